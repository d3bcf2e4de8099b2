import { expect, test } from 'vitest';
import { turnFlaps } from '../../../../src/mesh/bake/bakeOutlines.js';
import { finish } from '../meshes.js';
import { patch } from '../shapes.js';

/** A flat patch whose vertices are its fans, with every normal up but that of one vertex in the middle, tilted by `degrees`. */
function turnedNormal(degrees: number, vertex: number) {
  const { indices, positions } = patch(6, 6, (u, v) => [u, v, 0]);
  const count = positions.length / 3;
  const normals = new Float32Array(3 * count).map((_, i) => (i % 3 === 2 ? 1 : 0));
  const angle = (degrees * Math.PI) / 180;
  normals.set([Math.sin(angle), 0, Math.cos(angle)], 3 * vertex);
  const before = normals.slice();
  finish(turnFlaps(normals, { ofCorner: indices, count }));
  return { before, normals, own: [...normals.subarray(3 * vertex, 3 * vertex + 3)] };
}

const MIDDLE = 24;

test.each([0, 45, 69])('a normal tilted by %i° stays', (degrees) => {
  const { before, normals } = turnedNormal(degrees, MIDDLE);
  expect(normals).toEqual(before);
});

test.each([71, 90, 135, 180])(
  'one tilted by %i° becomes the mean of those around it, and no other changes',
  (degrees) => {
    const { before, normals, own } = turnedNormal(degrees, MIDDLE);
    expect(own).toEqual([0, 0, 1]);
    before.set(own, 3 * MIDDLE);
    expect(normals).toEqual(before);
  },
);

test('the mean is that of all triangles around, and of unit length', () => {
  const up = [0, 0, 1];
  const aside = [0, 1, 0];
  // Vertex 0 is each corner of one triangle.
  const ofCorner = new Uint32Array([0, 1, 2, 3, 0, 2, 3, 1, 0]);
  const normals = new Float32Array([[0, -0.6, -0.8], up, up, aside].flat());
  finish(turnFlaps(normals, { ofCorner, count: 4 }));
  const expected = [0, 2 / Math.hypot(2, 4), 4 / Math.hypot(2, 4)];
  for (const [axis, value] of expected.entries()) expect(normals[axis]).toBeCloseTo(value, 6);
});

test('normals stay if the others are zero or contradict each other', () => {
  const alone = new Float32Array([0, 0, 1, 1, 0, 0, -1, 0, 0, 0, 1, 0]);
  const before = alone.slice();
  finish(turnFlaps(alone, { ofCorner: new Uint32Array([0, 1, 2]), count: 4 }));
  expect([...alone.subarray(0, 3), ...alone.subarray(9)]).toEqual([...before.subarray(0, 3), ...before.subarray(9)]);
  expect(alone.every(Number.isFinite)).toBe(true);
});
