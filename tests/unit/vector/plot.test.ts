import { describe, expect, test } from 'vitest';
import { PLOTTERS, plotTimes } from '../../../src/vector/plot/plotTime.js';
import { refills } from '../../../src/vector/plot/refills.js';

describe('refills', () => {
  const runsOf = (lengths: readonly number[], most: number | null) =>
    refills(
      lengths.map((length) => ({ length })),
      most,
    ).map((run) => run.map(({ length }) => length));

  test('each run is as long as the pen lasts, and what is longer stays whole', () => {
    expect(runsOf([4, 3, 5, 20, 1, 1], 10)).toEqual([[4, 3], [5], [20], [1, 1]]);
    expect(runsOf([4, 3, 5], 12)).toEqual([[4, 3, 5]]);
    expect(runsOf([4, 3], null)).toEqual([[4, 3]]);
    expect(runsOf([], 10)).toEqual([[]]);
  });
});

describe('the time of plotting', () => {
  const plotter = { draw: 10, travel: 100, fastest: 40, drawAcceleration: 100, travelAcceleration: 1000, lift: 0.5 };
  const seconds = (...given: Parameters<typeof plotTimes>) => plotTimes(...given).at(-1);
  const path = (x: number, length: number) => ({ length, start: [x, 0], end: [x + length, 0] }) as const;

  test('is by hand: speeding up, drawing, slowing down, and lifts', () => {
    // Travel of 10 mm at 100 mm/s and 1000 mm/s²: just reaches its speed, 0.2 s. 20 mm at 10 mm/s: 2 s, and 0.1 s for speeding up and slowing down.
    expect(seconds([path(10, 20)], plotter)).toBeCloseTo(0.2 + 0.5 + 2.1, 9);
    // A stroke of 0.25 mm never reaches its speed: 2 √(0.25 / 100).
    expect(seconds([path(0, 0.25)], plotter)).toBeCloseTo(0.5 + 0.1, 9);
    // The second begins where the first ends.
    const [first, second] = plotTimes([path(0, 20), path(20, 20)], plotter);
    expect(first).toBeCloseTo(0.5 + 2.1, 9);
    expect(second).toBeCloseTo(2 * first, 9);
  });

  test('a pen of half the greatest speed draws at that', () => {
    expect(seconds([path(0, 200)], plotter, 50)).toBeCloseTo(0.5 + 200 / 20 + 20 / 100, 9);
  });

  test('many short strokes take longer than one of their length', () => {
    const short = Array.from({ length: 100 }, (_, i) => path(i, 1));
    expect(seconds(short, PLOTTERS.axidraw)).toBeGreaterThan(3 * seconds([path(0, 100)], PLOTTERS.axidraw)!);
  });
});
