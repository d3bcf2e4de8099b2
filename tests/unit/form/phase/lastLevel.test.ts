import { describe, expect, test } from 'vitest';
import { roundJumps, solveLastPart } from '../../../../src/form/phase/lastLevel.js';
import type { LastPart } from '../../../../src/form/phase/PhaseSystem.js';
import { noise } from '../../mesh/shapes.js';

/** A part whose factor L has these rows. */
const partOf = (nodes: number[], jumps: number[], rows: readonly (readonly number[])[]): LastPart => ({
  nodes,
  jumps,
  factor: new Float64Array(rows.flatMap((row) => rows.map((_, column) => row[column] ?? 0))),
  inverses: new Float64Array(rows.map((row, i) => 1 / row[i])),
});

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

describe('roundJumps', () => {
  /** Jumps of φ and φ₂, one after the other. */
  const rounded = (parts: readonly LastPart[], ...jumps: number[]) => {
    const values = Float64Array.from(jumps);
    roundJumps(parts, values);
    return [...values];
  };

  test('to multiples of 4, and of 2 for lines that cross; of two jumps that are held to each other, one up and the other down', () => {
    // Their energy is (x + y)² and a little more.
    const part = partOf([0], [0, 1], [[1], [0, 1], [0, 1, 0.1]]);
    expect(rounded([part], 21.6, 10.8, 5.8, 2.8)).toEqual([24, 12, 4, 2]);
  });

  test('where little would be left, to 2 or 1', () => {
    const part = partOf([0], [0], [[1], [0, 1]]);
    expect(rounded([part], 1.3, 0.8)).toEqual([1, 1]);
    expect(rounded([part], 2.3, 12.9)).toEqual([2, 12]);
    expect(rounded([part], 9.1, 0.1)).toEqual([8, 0]);
  });

  test('jumps of no part are rounded to the nearest', () => {
    expect(rounded([], 5.6, -1.2, 13.4, 0.1)).toEqual([4, -2, 12, 0]);
  });
});
