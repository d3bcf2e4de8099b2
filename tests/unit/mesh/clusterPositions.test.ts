import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { clusterPositions } from '../../../src/mesh/clusterPositions.js';
import { finish } from './meshes.js';
import { noise } from './shapes.js';

type Point = [x: number, y: number, z: number];

const cluster = (points: readonly Point[], tolerance: number) =>
  finish(clusterPositions(new Float32Array(points.flat()), Uint32Array.from(points.keys()), tolerance));

/** Every pair compared with every other. */
function clusteredPlainly(points: readonly Point[], tolerance: number): number[] {
  const first = points.map((_, i) => i);
  const near = (a: number, b: number) =>
    [0, 1, 2].every((k) => Math.abs(Math.fround(points[a][k]) - Math.fround(points[b][k])) <= tolerance);
  for (let hasChanged = true; hasChanged; ) {
    hasChanged = false;
    for (const a of first.keys()) {
      for (const b of first.keys()) {
        if (first[b] <= first[a] || !near(a, b)) continue;
        first[b] = first[a];
        hasChanged = true;
      }
    }
  }
  return first;
}

const examples = { seed: 20080, numRuns: 500 };

const coordinate = fc.oneof(fc.integer({ min: -4, max: 4 }), fc.float({ noNaN: true, min: -4, max: 4 }));
const points = fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 1, maxLength: 30 });

describe('clusters of positions', () => {
  test('are the connected components of all pairs within the tolerance', () => {
    fc.assert(
      fc.property(points, fc.constantFrom(0.25, 0.7, 1, 1.5, 20), (list, tolerance) => {
        expect([...cluster(list, tolerance).first]).toEqual(clusteredPlainly(list, tolerance));
      }),
      examples,
    );
  });

  test('depend neither on the order of the positions nor on the grid', () => {
    fc.assert(
      fc.property(points, fc.infiniteStream(fc.nat(1_000_000)), coordinate, (list, random, corner) => {
        const order = list
          .map((_, i) => ({ i, key: random.next().value as number }))
          .sort((a, b) => a.key - b.key)
          .map(({ i }) => i);
        const before = cluster(list, 1).first;
        // The grid begins at the smallest coordinates: a point further out moves it.
        const after = cluster([...order.map((i) => list[i]), [corner - 12, corner - 12, corner - 12]], 1).first;
        const together = (first: Uint32Array, a: number, b: number) => first[a] === first[b];
        for (const [a, i] of order.entries()) {
          for (const [b, j] of order.entries()) expect(together(after, a, b)).toBe(together(before, i, j));
        }
      }),
      { ...examples, numRuns: 200 },
    );
  });

  const random = noise(7);
  const crowd = (count: number, center: Point, size: number): Point[] =>
    Array.from({ length: count }, () => center.map((value) => value + (size / 2) * random()) as Point);

  test.each<[string, Point[], number]>([
    ['in one cell', crowd(100_000, [0.5, 0.5, 0.5], 0.9), 1],
    ['in one cell, and the grid far larger', [...crowd(100_000, [0.5, 0.5, 0.5], 0.9), [1000, 1000, 1000]], 2],
    ['in two cells that touch nowhere', [...crowd(50_000, [0, 0, 0], 0.6), ...crowd(50_000, [1.7, 1.2, 0], 0.6)], 2],
    ['in two cells that touch', [...crowd(50_000, [0, 0, 0], 0.6), ...crowd(50_000, [1.3, 0.5, 0], 0.6)], 1],
  ])('100,000 positions %s take linear time', (_, list, clusters) => {
    const { first, steps } = cluster(list, 1);
    expect(new Set(first).size).toBe(clusters);
    expect(steps / list.length).toBeLessThan(30);
  });
});
