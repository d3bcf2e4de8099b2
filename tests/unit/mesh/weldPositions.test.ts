import fc from 'fast-check';
import { expect, test } from 'vitest';
import { weldPositions } from '../../../src/mesh/weldPositions.js';
import { finish, meshOf } from './meshes.js';

const weld = (vertices: number[][]) => finish(weldPositions(meshOf(vertices, []).positions));

test('vertices at one position share the first of them, −0 counts as 0, and nearly is not equal', () => {
  const { canonical } = weld([
    [0, 0, 0],
    [1, 0, 0],
    [0, -0, -0],
    [1, 1e-7, 0],
    [1, 0, -0],
    [0, 0, 1],
  ]);
  expect([...canonical]).toEqual([0, 1, 0, 3, 1, 5]);
});

test('agrees with a brute-force search', () => {
  const coordinate = fc.constantFrom(-1, -0, 0, 0.5, 1e-30, 3e38);
  fc.assert(
    fc.property(fc.array(fc.tuple(coordinate, coordinate, coordinate), { maxLength: 60 }), (vertices) => {
      const rounded = vertices.map((vertex) => vertex.map(Math.fround));
      const expected = rounded.map((a) => rounded.findIndex((b) => a.every((value, i) => value === b[i])));
      expect([...weld(vertices).canonical]).toEqual(expected);
    }),
    { seed: 20080 },
  );
});

test('a fine regular grid does not crowd the hash table', () => {
  // The bits of such coordinates differ in few places, all of them high.
  const side = 40;
  const vertices = Array.from({ length: side ** 3 }, (_, i) => [
    i % side,
    Math.floor(i / side) % side,
    Math.floor(i / side ** 2),
  ]);
  expect(weld(vertices).steps / vertices.length).toBeLessThan(2);
});
