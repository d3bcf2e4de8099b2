import { describe, expect, test } from 'vitest';
import { cleanMesh } from '../../../../../src/viewer/files/mesh/cleanMesh.js';

const POSITIONS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const mesh = (positions: number[], indices: number[]) => ({
  positions: new Float32Array(positions),
  normals: null,
  colors: null,
  indices: new Uint32Array(indices),
});

describe('cleanMesh', () => {
  test('a mesh with nothing to remove is not copied', () => {
    const clean = mesh(POSITIONS, [0, 1, 2, 0, 2, 3]);
    const { mesh: kept, broken } = cleanMesh(clean);
    expect(kept.positions).toBe(clean.positions);
    expect(kept.indices).toBe(clean.indices);
    expect(broken).toBe(0);
  });

  test.each([
    ['a corner that is missing', POSITIONS, [0, 1, 2, 0, 2, 3, 0, 1, 4], 4, 1],
    ['a vertex that is no number', [...POSITIONS, NaN, 0, 0], [0, 1, 2, 0, 2, 3, 0, 1, 4], 4, 1],
    ['a vertex that is infinite', [...POSITIONS, 0, Infinity, 0], [0, 1, 2, 0, 2, 3, 0, 1, 4], 4, 1],
    ['a vertex of no depth', [...POSITIONS, 0, 0, NaN], [0, 1, 2, 0, 2, 3, 0, 1, 4], 4, 1],
    ['a vertex without a triangle', [...POSITIONS, 9, 9, 9], [0, 1, 2, 0, 2, 3], 4, 0],
    ['a triangle that lacks a corner', POSITIONS, [0, 1, 2, 0, 2, 3].slice(0, 4), 3, 0],
  ])('%s', (_, positions, indices, vertices, broken) => {
    const cleaned = cleanMesh(mesh(positions, indices));
    expect(cleaned.mesh.positions).toHaveLength(3 * vertices);
    expect(cleaned.mesh.indices!.every((vertex) => vertex < vertices)).toBe(true);
    expect(cleaned.broken).toBe(broken);
  });

  test('a view of a longer array is copied, since the whole buffer would be transferred', () => {
    const longer = new Uint32Array([0, 1, 2, 0, 2, 3, 0, 0, 0]);
    const { mesh: kept } = cleanMesh({ ...mesh(POSITIONS, []), indices: longer.subarray(0, 6) });
    expect(kept.indices!.buffer.byteLength).toBe(24);
  });
});
