import { DoubleSide, FrontSide } from 'three';
import { expect, test } from 'vitest';
import { bakeMesh } from '../../../../src/viewer/drawing/bakeMesh.js';

const CORNERS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1];
const TETRAHEDRON = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];

const sideOf = async (triangles: number[]) => {
  const mesh = {
    positions: new Float32Array(CORNERS),
    normals: null,
    colors: null,
    indices: new Uint32Array(triangles),
  };
  return (await bakeMesh(mesh)).side;
};

test('closed meshes are single-sided, also with flaps of two triangles back to back', async () => {
  expect(await sideOf(TETRAHEDRON)).toBe(FrontSide);
  // The back of a flap would lie on its front, dark in the light.
  expect(await sideOf([...TETRAHEDRON, 1, 2, 4, 4, 2, 1])).toBe(FrontSide);
});

test.each([
  ['a hole', TETRAHEDRON.slice(3)],
  ['a fin of one triangle', [...TETRAHEDRON, 1, 2, 4]],
  ['a triangle that is turned over', [0, 1, 2, ...TETRAHEDRON.slice(3)]],
])('what has %s is drawn from both sides', async (_, triangles) => {
  expect(await sideOf(triangles)).toBe(DoubleSide);
});
