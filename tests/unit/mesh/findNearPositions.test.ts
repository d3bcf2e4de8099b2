import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { findNearPositions } from '../../../src/mesh/adjacency/joinBorders.js';
import { finish } from './meshes.js';
import { noise } from './shapes.js';

const TOLERANCE = 1 / 64;

const find = (points: readonly (readonly number[])[], tolerance = TOLERANCE) =>
  finish(findNearPositions(new Float32Array(points.flat()), Uint32Array.from(points.keys()), tolerance));

/** A number of tolerances in [−1, 1] that single precision holds exactly. */
const step = fc.integer({ min: -8, max: 8 }).map((eighths) => (eighths / 8) * TOLERANCE);

/** Near the multiples of 1/8, which is half a cell: every other one is a border between cells. */
const coordinate = fc.tuple(fc.integer({ min: -8, max: 8 }), step).map(([place, offset]) => place / 8 + offset);

describe('positions that may be near another one', () => {
  test('include all that differ from another by no more than the tolerance along each axis', () => {
    fc.assert(
      fc.property(fc.tuple(coordinate, coordinate, coordinate), fc.tuple(step, step, step), (first, steps) => {
        const second = first.map((value, axis) => value + steps[axis]);
        expect([...find([first, second]).near]).toEqual([0, 1]);
      }),
      { seed: 20080, numRuns: 2000 },
    );
  });

  test('are few of those that lie far apart, in linear time', () => {
    const random = noise(3);
    const points = Array.from({ length: 100_000 }, () => [random(), random(), 0]);
    const { near, steps } = find(points, 1e-6);
    expect(near.length).toBeLessThan(20_000);
    expect(steps / points.length).toBeLessThan(1.3);
  });

  test('are returned as entries of the list, in order', () => {
    const positions = new Float32Array([9, 9, 9, 0, 0, 0, 5, 5, 5, 0, 0, 0]);
    expect([...finish(findNearPositions(positions, Uint32Array.of(3, 2, 1), TOLERANCE)).near]).toEqual([3, 1]);
  });
});
