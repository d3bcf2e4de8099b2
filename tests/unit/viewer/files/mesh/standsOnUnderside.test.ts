import { BoxGeometry, type BufferGeometry, CylinderGeometry, SphereGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { findUpAxis } from '../../../../../src/viewer/files/mesh/findUpAxis.js';
import { standsOnUnderside } from '../../../../../src/viewer/files/mesh/standsOnUnderside.js';

const quarter = Math.PI / 2;
const body = (): BufferGeometry => new SphereGeometry(1, 48, 24).scale(0.8, 0.5, 1.8);
const runners = (): BufferGeometry[] => [-0.5, 0.5].map((x) => new BoxGeometry(0.2, 0.6, 2).translate(x, -0.3, -0.5));
const box = (size: [number, number, number], at: [number, number, number]): BufferGeometry =>
  new BoxGeometry(...size).translate(...at);
const rest = (): BufferGeometry => box([1.2, 1.2, 0.5], [0, 0.6, -1.2]);
/** A long body on two runners, with a back rest at one end and its up axis along y. */
const sledge = (): BufferGeometry => mergeGeometries([body(), ...runners(), rest()]);

const stands = (geometry: BufferGeometry): boolean =>
  standsOnUnderside(geometry.getAttribute('position').array, geometry.index?.array ?? null, 'y');

describe('a model stands on its underside', () => {
  test('if that is broad, uneven, and below two like halves', () => {
    expect(stands(sledge())).toBe(true);
    expect(stands(sledge().rotateY(0.7))).toBe(true);
  });

  test.each([
    [
      'only a few points touch the ground, as of a lying figure',
      mergeGeometries([
        body(),
        rest(),
        ...[-0.4, 0.4].flatMap((x) => [-1, 1].map((z) => new SphereGeometry(0.1, 12, 8).translate(x, -0.5, z))),
      ]),
    ],
    [
      'it is flat, as the back of what hangs on a wall',
      mergeGeometries([body(), rest(), box([1.6, 0.6, 3.6], [0, -0.3, 0])]),
    ],
    ['no upright plane mirrors it', mergeGeometries([body().rotateY(0.7), ...runners(), rest()])],
    ['turning maps it onto itself', new CylinderGeometry(1.2, 0.6, 1, 48)],
  ])('but not where %s', (_, geometry) => {
    expect(stands(geometry)).toBe(false);
  });
});

describe('the axis that points up', () => {
  const standing = (geometry: BufferGeometry, up: 'y' | 'z', liesFlat = false) =>
    findUpAxis(geometry.getAttribute('position').array, geometry.index?.array ?? null, { up, liesFlat });

  test('is the other usual one of a long body that stands on its end', () => {
    expect(standing(sledge().rotateX(quarter), 'y')).toEqual({ up: 'z', on: 'underside' });
    expect(standing(sledge(), 'z')).toEqual({ up: 'y', on: 'underside' });
  });

  test('is the usual one of a body on its underside, and in a format for printers', () => {
    expect(standing(sledge(), 'y')).toBeUndefined();
    expect(standing(sledge(), 'z', true)).toBeUndefined();
  });
});
