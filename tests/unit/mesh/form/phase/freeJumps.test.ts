import { describe, expect, test } from 'vitest';
import {
  bindJumps,
  type FreeJumps,
  freeJumps,
  type JumpEquations,
  releaseJumps,
} from '../../../../../src/mesh/form/phase/freeJumps.js';
import { noise } from '../../shapes.js';

type Terms = readonly (readonly [segment: number, sign: number])[];

const equationsOf = (rows: readonly Terms[]): JumpEquations => {
  const starts = [0];
  for (const row of rows) starts.push(starts[starts.length - 1] + row.length);
  return { starts, segments: rows.flat().map(([segment]) => segment), signs: rows.flat().map(([, sign]) => sign) };
};

/** The jumps of all segments, of one family, from the free ones. */
function solve(jumps: FreeJumps, segmentCount: number, free: readonly number[]): number[] {
  const all = new Float64Array(2 * segmentCount);
  for (const [i, segment] of jumps.free.entries()) all[2 * segment] = free[i];
  bindJumps(jumps, all);
  return [...all].filter((_, i) => i % 2 === 0);
}

const sum = (terms: Terms, jumps: readonly number[]): number =>
  terms.reduce((total, [segment, sign]) => total + sign * jumps[segment], 0);

/** How many of the equations are independent of each other, by elimination of dense rows. */
function rankOf(rows: readonly Terms[], segmentCount: number): number {
  const dense = rows.map((terms) => {
    const row = new Array<number>(segmentCount).fill(0);
    for (const [segment, sign] of terms) row[segment] += sign;
    return row;
  });
  let rank = 0;
  for (let column = 0; column < segmentCount; column++) {
    const pivot = dense.findIndex((row, i) => i >= rank && Math.abs(row[column]) > 1e-9);
    if (pivot < 0) continue;
    [dense[rank], dense[pivot]] = [dense[pivot], dense[rank]];
    for (let i = rank + 1; i < dense.length; i++) {
      const factor = dense[i][column] / dense[rank][column];
      dense[i] = dense[i].map((value, k) => value - factor * dense[rank][k]);
    }
    rank++;
  }
  return rank;
}

/** Segments that join points by chance; a share of the ends is free. */
function network(points: number, segmentCount: number, freeShare: number, seed: number): [number, number][][] {
  const random = noise(seed);
  const rows = Array.from({ length: points }, (): [number, number][] => []);
  for (let segment = 0; segment < segmentCount; segment++) {
    for (let end = 0; end < 2; end++) {
      if ((random() + 1) / 2 < freeShare) continue;
      rows[Math.floor(((random() + 1) / 2) * points)].push([segment, random() < 0 ? -1 : 1]);
    }
  }
  return rows;
}

describe('freeJumps', () => {
  test('three segments that meet in a point, and end freely: two are free', () => {
    const rows: Terms[] = [
      [
        [0, 1],
        [1, -1],
        [2, 1],
      ],
    ];
    const jumps = freeJumps(equationsOf(rows), 3);
    expect(jumps.free).toHaveLength(2);
    expect(sum(rows[0], solve(jumps, 3, [5, 7]))).toBe(0);
  });

  test('the jump of a closed segment is free if its sign returns, else zero', () => {
    const loop = (sign: number): Terms[] => [
      [
        [0, 1],
        [0, sign],
      ],
    ];
    expect([...freeJumps(equationsOf(loop(-1)), 1).free]).toEqual([0]);
    const odd = freeJumps(equationsOf(loop(1)), 1);
    expect(odd.free).toHaveLength(0);
    expect(solve(odd, 1, [])).toEqual([0]);
  });

  test.each(Array.from({ length: 60 }, (_, seed) => seed))('a network of chance, %i', (seed) => {
    const segmentCount = 1 + (seed % 30);
    const rows = network(1 + (seed % 11), segmentCount, seed % 3 === 0 ? 0 : 0.1, seed);
    const jumps = freeJumps(equationsOf(rows), segmentCount);
    expect(jumps.free.length).toBe(segmentCount - rankOf(rows, segmentCount));

    const random = noise(seed + 100);
    const free = [...jumps.free].map(() => Math.round(9 * random()));
    const all = solve(jumps, segmentCount, free);
    for (const row of rows) expect(sum(row, all) + 0).toBe(0);
    for (const jump of all) expect(Number.isInteger(jump)).toBe(true);

    const pulls = Array.from({ length: segmentCount }, random);
    const released = new Float64Array(pulls.flatMap((pull) => [0, pull]));
    releaseJumps(jumps, released);
    const atFree = [...jumps.free].reduce((total, segment, i) => total + released[2 * segment + 1] * free[i], 0);
    expect(atFree).toBeCloseTo(
      pulls.reduce((total, pull, segment) => total + pull * all[segment], 0),
      9,
    );
  });
});
