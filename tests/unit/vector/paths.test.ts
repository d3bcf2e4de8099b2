import { describe, expect, test } from 'vitest';
import { walkSegments } from '../../../src/vector/levelSegments.js';
import { pathData } from '../../../src/vector/paths/finishPaths.js';
import { dashes, pathLength, simplify } from '../../../src/vector/paths/LinePath.js';
import {
  asDrawn,
  type OrderedPath,
  orderPaths,
  type PathEnds,
  travelOf,
} from '../../../src/vector/paths/orderPaths.js';
import { clipRing, strokeOutline } from '../../../src/vector/paths/strokeOutline.js';
import { finished } from './finished.js';
import { ringsOf } from './paths.js';
import { randomNumbers } from './randomNumbers.js';

const random = randomNumbers(9);
const areaOf = (ring: readonly number[]): number => {
  let sum = 0;
  for (let i = 0; i < ring.length; i += 2) {
    const next = (i + 2) % ring.length;
    sum += ring[i] * ring[next + 1] - ring[next] * ring[i + 1];
  }
  return sum / 2;
};

describe('simplify', () => {
  const wave = Array.from({ length: 400 }, (_, i) => [
    i / 10,
    Math.sin(i / 40),
    0.5 + 0.4 * Math.sin(i / 30),
    0.5,
  ]).flat();

  test('leaves out points, keeps both ends, and strays by no more than asked in place and width', () => {
    const { points } = simplify({ points: wave, isClosed: false }, 0.02);
    expect(points.length).toBeLessThan(wave.length / 5);
    expect(points.slice(0, 4)).toEqual(wave.slice(0, 4));
    expect(points.slice(-4)).toEqual(wave.slice(-4));
    for (let i = 0; i < wave.length; i += 4) {
      let k = 0;
      while (points[k + 4] < wave[i]) k += 4;
      const t = (wave[i] - points[k]) / (points[k + 4] - points[k]);
      for (const n of [1, 2]) {
        const there = points[k + n] + t * (points[k + 4 + n] - points[k + n]);
        expect(Math.abs(there - wave[i + n])).toBeLessThan(0.025);
      }
    }
  });

  test('keeps a closed path closed', () => {
    const circle = Array.from({ length: 200 }, (_, i) => [Math.cos(i / 31.83), Math.sin(i / 31.83), 0.1, 0.1]).flat();
    const path = simplify({ points: circle, isClosed: true }, 0.01);
    expect(path.isClosed).toBe(true);
    expect(path.points.length).toBeLessThan(circle.length / 3);
    expect(pathLength(path)).toBeCloseTo(2 * Math.PI, 1);
  });
});

describe('strokeOutline', () => {
  test('covers as much as its widths say', () => {
    const points = Array.from({ length: 50 }, (_, i) => [0.8 * i, 0.6 * i, 0.2 + i / 100, 0.1]).flat();
    const [ring] = strokeOutline({ points, isClosed: false });
    // The mean of the widths times the length.
    expect(Math.abs(areaOf(ring))).toBeCloseTo(49 * (0.1 + 0.2 + 0.245), 6);
  });

  test('has two rings where it is closed, which run against each other', () => {
    const points = Array.from({ length: 100 }, (_, i) => [
      5 * Math.cos(i / 15.915),
      5 * Math.sin(i / 15.915),
      0.5,
      0.5,
    ]).flat();
    const [outer, inner] = strokeOutline({ points, isClosed: true });
    expect(areaOf(outer) * areaOf(inner)).toBeLessThan(0);
    expect(Math.abs(areaOf(outer) + areaOf(inner))).toBeCloseTo(2 * Math.PI * 5, 0);
  });
});

describe('clipRing', () => {
  test('keeps what lies inside, and cuts areas at the limits', () => {
    const square = [-1, -1, 3, -1, 3, 3, -1, 3];
    expect(Math.abs(areaOf(clipRing(square, 2, 2)))).toBeCloseTo(4, 12);
    expect(clipRing([0.5, 0.5, 1, 0.5, 1, 1], 2, 2)).toEqual([0.5, 0.5, 1, 0.5, 1, 1]);
    expect(clipRing([3, 3, 4, 3, 4, 4], 2, 2)).toEqual([]);
    for (const x of clipRing([-1, 1, 1, -1, 3, 1, 1, 3], 2, 2)) expect(x >= 0 && x <= 2).toBe(true);
  });
});

describe('clipRing, at slanted sides,', () => {
  test('cuts where a side meets the limit, whichever way it runs', () => {
    // A side from inside to outside, and one back, each a quarter of its length.
    const triangle = [1, 1, 5, 1.8, 1, 1.9];
    const clipped = clipRing(triangle, 2, 2);
    expect(clipped).toHaveLength(8);
    for (const [i, value] of [1, 1, 2, 1.2, 2, 1.875, 1, 1.9].entries()) expect(clipped[i]).toBeCloseTo(value, 12);
    // Crossings lie exactly on the limit.
    expect([clipped[2], clipped[4]]).toEqual([2, 2]);
  });
});

describe('dashes', () => {
  test('begin and end a path, are equally long, and lie equally far from each other', () => {
    const path = { points: [0, 0, 1, 1, 10, 0, 1, 1, 10, 13, 3, 3], isClosed: false };
    const cut = dashes(path, 3, 2);
    expect(cut.length).toBe(5);
    expect(cut[0].points.slice(0, 4)).toEqual([0, 0, 1, 1]);
    const last = cut.at(-1)!.points.slice(-4);
    for (const [i, value] of [10, 13, 3, 3].entries()) expect(last[i]).toBeCloseTo(value, 12);
    const lengths = cut.map((dash) => pathLength(dash));
    for (const length of lengths) expect(length).toBeCloseTo((3 * 25) / 25, 12);
    expect(cut.every(({ isClosed }) => !isClosed)).toBe(true);
  });

  test('go once around a closed path, and a short path stays whole', () => {
    const square = { points: [0, 0, 1, 1, 6, 0, 1, 1, 6, 6, 1, 1, 0, 6, 1, 1], isClosed: true };
    const cut = dashes(square, 2, 1);
    const end = cut.at(-1)!.points.slice(-4);
    for (const [i, value] of [0, 0, 1, 1].entries()) expect(end[i]).toBeCloseTo(value, 12);
    const short = { points: [0, 0, 1, 1, 3, 0, 1, 1], isClosed: false };
    expect(dashes(short, 3, 2)).toEqual([short]);
  });
});

/** All orders of paths, with each path in both directions. */
function ordersOf(paths: readonly number[]): OrderedPath[][] {
  if (paths.length === 0) return [[]];
  return paths.flatMap((path) =>
    ordersOf(paths.filter((other) => other !== path)).flatMap((rest) =>
      [false, true].map((isReversed) => [{ path, isReversed }, ...rest]),
    ),
  );
}

describe('orderPaths', () => {
  const paths: PathEnds[] = Array.from({ length: 900 }, () => {
    const start = [200 * random(), 200 * random()] as const;
    return { start, end: [start[0] + 10 * random(), start[1] + 10 * random()] as const };
  });

  test('takes each path once, and a far shorter way', () => {
    const order = finished(orderPaths(paths));
    expect(order.map(({ path }) => path).sort((a, b) => a - b)).toEqual(paths.map((_, i) => i));
    expect(travelOf(paths, order)).toBeLessThan(0.0335 * travelOf(paths, asDrawn(paths)));
    expect(finished(orderPaths(paths))).toEqual(order);
  });

  test('is as good as all orders of six paths tried out, but for a twentieth', () => {
    let [best, ours] = [0, 0];
    for (let k = 0; k < 12; k++) {
      const few = Array.from({ length: 6 }, (): PathEnds => {
        const at = () => [100 * random(), 100 * random()] as const;
        return { start: at(), end: at() };
      });
      ours += travelOf(few, finished(orderPaths(few)));
      best += Math.min(...ordersOf([0, 1, 2, 3, 4, 5]).map((order) => travelOf(few, order)));
    }
    expect(ours).toBeLessThan(1.05 * best);
    expect(ours).toBeGreaterThanOrEqual(best - 1e-9);
  });

  test('has nothing to do for no path, for one, and for those at one place', () => {
    expect(finished(orderPaths([]))).toEqual([]);
    const one: PathEnds = { start: [3, 4], end: [0, 1] };
    expect(finished(orderPaths([one]))).toEqual([{ path: 0, isReversed: true }]);
    const alike = Array.from({ length: 20 }, (): PathEnds => ({ start: [1, 1], end: [1, 1] }));
    expect(finished(orderPaths(alike)).length).toBe(20);
  });
});

test('path data comes back as the points it was written from, to hundredths of a millimetre', () => {
  const points = Array.from({ length: 80 }, () => 300 * random() - 20);
  const [read] = ringsOf(pathData(points, false, { scale: 0.3, left: 5, top: 5 }));
  expect(read.length).toBe(points.length);
  // Rounding errors do not add up along the path.
  for (const [i, x] of points.entries()) expect(Math.abs(read[i] - (5 + 0.3 * x))).toBeLessThan(0.0051);
  expect(pathData([1, 1, 2, 1, 2, 2], false, { scale: 1, left: 0, top: 0 })).toBe('M1 1l1 0 0 1');
  expect(pathData([1, 1, 2, 1, 2, 2], true, { scale: 1, left: 0, top: 0 })).toBe('M1 1l1 0 0 1z');
  expect(pathData([1, 1, 1.001, 1], true, { scale: 0.3, left: 0, top: 0 })).toBe('');
});

describe('walkSegments', () => {
  const walksOf = (starts: number[], ends: number[]) =>
    [...walkSegments(starts, ends, 1 + Math.max(...starts, ...ends))].map((walk) => [walk?.segments, walk?.isClosed]);

  test('joins segments in whatever order and direction they come', () => {
    expect(walksOf([1, 3, 1], [2, 2, 0])).toEqual([[[2, 0, 1], false]]);
  });

  test('recognizes rings', () => {
    expect(walksOf([0, 1, 2], [1, 2, 0])[0][1]).toBe(true);
    expect(walksOf([0, 2, 2], [1, 1, 0])[0][1]).toBe(true);
  });

  test('uses each segment once where more than two meet', () => {
    const walks = walksOf([0, 0, 0, 0], [1, 2, 3, 4]);
    expect(walks.flatMap(([segments]) => segments as number[]).sort()).toEqual([0, 1, 2, 3]);
  });
});
