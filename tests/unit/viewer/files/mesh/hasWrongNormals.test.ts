import { BoxGeometry, type BufferGeometry, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import { hasWrongNormals } from '../../../../../src/viewer/files/mesh/hasWrongNormals.js';

type Vector = [x: number, y: number, z: number];

/** Whether the normals of a geometry are wrong, after each was changed. @param change gets the normal and the number of its vertex */
function isWrong(geometry: BufferGeometry, change: (normal: Vector, vertex: number) => Vector): boolean {
  const { position, normal } = geometry.attributes;
  const normals = Array.from({ length: normal.count }, (_, i) =>
    change([normal.getX(i), normal.getY(i), normal.getZ(i)], i),
  );
  return hasWrongNormals({
    positions: Float32Array.from(position.array),
    normals: Float32Array.from(normals.flat()),
    colors: null,
    indices: geometry.index && Uint32Array.from(geometry.index.array),
  });
}

const box = () => new BoxGeometry();
/** A normal that lies in the side of a box, for vertices of its first sides. */
const alongFirst =
  (sides: number) =>
  ([x, y, z]: Vector, vertex: number): Vector =>
    vertex < 4 * sides ? [y, z, x] : [x, y, z];

test.each<[string, BufferGeometry, (normal: Vector, vertex: number) => Vector, boolean]>([
  ['right', box(), (normal) => normal, false],
  ['of a smoothly shaded box', box(), ([x, y, z]) => [x || 1, y || 1, z || 1], false],
  ['of a coarse ball', new SphereGeometry(1, 6, 4), (normal) => normal, false],
  ['turned around', box(), ([x, y, z]) => [-x, -y, -z], false],
  ['longer than 1', box(), ([x, y, z]) => [9 * x, 9 * y, 9 * z], false],
  ['missing', box(), () => [0, 0, 0], false],
  ['the same all over', box(), () => [0, 0, 1], true],
  ['the same all over, without an index', box().toNonIndexed(), () => [0, 0, 1], true],
  ['wrong on one of six sides', box(), alongFirst(1), false],
  ['wrong on two of six sides', box(), alongFirst(2), true],
  ['leaning by 59°', box(), lean(59), false],
  ['leaning by 61°', box(), lean(61), true],
])('normals that are %s', (_, geometry, change, expected) => {
  expect(isWrong(geometry, change)).toBe(expected);
});

test('a mesh without normals has no wrong ones', () => {
  expect(hasWrongNormals({ positions: new Float32Array(9), normals: null, colors: null, indices: null })).toBe(false);
});

/** Tilts a normal along an axis towards the next axis. */
function lean(degrees: number): (normal: Vector) => Vector {
  const [along, across] = [Math.cos, Math.sin].map((of) => of((degrees * Math.PI) / 180));
  return ([x, y, z]) => [along * x + across * z, along * y + across * x, along * z + across * y];
}
