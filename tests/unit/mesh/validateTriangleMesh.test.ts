import { expect, test } from 'vitest';
import { type TriangleMesh, validateTriangleMesh } from '../../../src/mesh/TriangleMesh.js';
import { finish } from './meshes.js';

const validate = (positions: number[], indices: number[]) => {
  const mesh: TriangleMesh = { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
  return () => finish(validateTriangleMesh(mesh, 'caller: the thing'));
};

const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];

test.each([
  ['no triangles', validate(square, []), /^caller: the thing has no triangles\. Pass/],
  [
    'an incomplete triangle',
    validate(square, [0, 1, 2, 2, 1]),
    /^caller: the thing has 5 corners.*multiple of three\. Remove/,
  ],
  [
    'an index out of range',
    validate(square, [0, 1, 2, 2, 1, 4]),
    /^caller: the thing: corner 5 refers to vertex 4.*only 4 vertices\. Fix/,
  ],
  ['NaN', validate([0, 0, 0, 1, Number.NaN, 0, 0, 1, 0], [0, 1, 2]), /position of vertex 1 is \(1, NaN, 0\).*repair/],
  ['infinity', validate([0, 0, 0, 1, 0, 0, 0, 1, -Infinity], [0, 1, 2]), /position of vertex 2 is \(0, 1, -Infinity\)/],
  [
    'too large for a float',
    validate([0, 0, 1e39, 1, 0, 0, 0, 1, 0], [0, 1, 2]),
    /position of vertex 0 is \(0, 0, Infinity\)/,
  ],
])('%s', (_, run, message) => {
  expect(run).toThrow(RangeError);
  expect(run).toThrow(message);
});

test('valid meshes pass, even with bad vertices that no triangle uses', () => {
  expect(validate([...square, Number.NaN, 0, 0], [0, 1, 2, 2, 1, 3])).not.toThrow();
  expect(validate([3e38, 0, 0, -3e38, 0, 0, 0, 3e38, 0], [0, 1, 2])).not.toThrow();
});
