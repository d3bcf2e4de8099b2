import { describe, expect, test } from 'vitest';
import { solveLastPart } from '../../../../../src/mesh/form/phase/precondition.js';
import { noise } from '../../shapes.js';
import { partOf } from './parts.js';

/** L·Lᵀ·x */
function product(rows: readonly (readonly number[])[], x: readonly number[]): number[] {
  const transposed = x.map((_, k) => rows.reduce((sum, row, i) => sum + (row[k] ?? 0) * (x[i] ?? 0), 0));
  return rows.slice(0, x.length).map((row) => row.reduce((sum, value, k) => sum + value * (transposed[k] ?? 0), 0));
}

describe('solveLastPart', () => {
  const random = noise(3);
  const rows = Array.from({ length: 5 }, (_, i) => Array.from({ length: i + 1 }, (_, k) => (k === i ? 2 : random())));
  // Nodes 4, 0, 2 and jumps 1, 0.
  const part = partOf([4, 0, 2], [1, 0], rows);

  test.each([
    ['nodes and jumps', true],
    ['nodes alone', false],
  ])('%s', (_, isFree) => {
    const count = isFree ? 5 : 3;
    const [x, x2] = [0, 1].map(() => Array.from({ length: count }, random));
    const forces = { nodes: new Float64Array(10), jumps: new Float64Array(4) };
    const values = { nodes: new Float64Array(10), jumps: new Float64Array(4) };
    for (const [family, solution] of [x, x2].entries()) {
      for (const [i, force] of product(rows, solution).entries()) {
        if (i < 3) forces.nodes[2 * part.nodes[i] + family] = force;
        else forces.jumps[2 * part.jumps[i - 3] + family] = force;
      }
    }
    solveLastPart(part, forces, values, isFree);
    for (const [family, solution] of [x, x2].entries()) {
      for (const [i, value] of solution.entries()) {
        const found = i < 3 ? values.nodes[2 * part.nodes[i] + family] : values.jumps[2 * part.jumps[i - 3] + family];
        expect(found).toBeCloseTo(value, 9);
      }
    }
  });
});
