import { describe, expect, test } from 'vitest';
import { triangulatePolygon } from '../../../../../src/viewer/files/mesh/triangulatePolygon.js';
import { COMB } from '../comb.js';

type Point = readonly number[];

/** The corners of triangles, turned so that the polygon lies askew in space, far from the origin. */
const askew = ([x, y]: Point): number[] => [
  100 + 0.6 * x,
  200 + 0.8 * x * 0.6 - 0.8 * y,
  300 + 0.8 * x * 0.8 + 0.6 * y,
];

const areaOf = (points: readonly Point[], triangles: readonly number[]): number => {
  let area = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]];
    const twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    // Every triangle turns as the polygon does.
    expect(twice).toBeGreaterThan(0);
    area += twice / 2;
  }
  return area;
};

const cut = (points: readonly Point[], holes: number[] = []): number[] => {
  const triangles = triangulatePolygon(points.flatMap(askew), holes);
  expect(
    triangulatePolygon(
      points.flatMap(([x, y]) => [x, y, 0]),
      holes,
    ),
  ).toHaveLength(triangles.length);
  return triangles;
};

const SQUARE = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

describe('a polygon', () => {
  test('without notches is a fan around its first corner', () => {
    expect(cut(SQUARE)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(cut(SQUARE.slice(0, 3))).toEqual([0, 1, 2]);
  });

  test.each([
    [
      'an arrowhead, from each of its corners',
      [
        [0, 0],
        [4, 2],
        [0, 4],
        [1, 2],
      ],
      6,
    ],
    [
      'an L',
      [
        [0, 0],
        [4, 0],
        [4, 1],
        [1, 1],
        [1, 4],
        [0, 4],
      ],
      7,
    ],
    ['a comb', COMB, 18],
  ])('with notches keeps them open: %s', (_what, points, area) => {
    for (let first = 0; first < points.length; first++) {
      const turned = [...points.slice(first), ...points.slice(0, first)];
      const triangles = cut(turned);
      expect(triangles).toHaveLength(3 * (points.length - 2));
      expect(areaOf(turned, triangles)).toBeCloseTo(area, 9);
    }
  });

  test('keeps holes open, in either winding', () => {
    const hole = [
      [1, 1],
      [2, 1],
      [2, 2],
      [1, 2],
    ];
    const other = [
      [3, 3],
      [3.5, 3],
      [3.5, 3.5],
      [3, 3.5],
    ];
    for (const first of [hole, [...hole].reverse()]) {
      const points = [...SQUARE, ...first, ...other];
      expect(areaOf(points, cut(points, [4, 8]))).toBeCloseTo(16 - 1 - 0.25, 9);
    }
  });

  test('with a hole that a slit joins to its outline keeps the hole open', () => {
    const points = [...SQUARE, [0, 0], [1, 1], [1, 2], [2, 2], [2, 1], [1, 1]];
    expect(areaOf(points, cut(points))).toBeCloseTo(15, 9);
  });

  test('keeps corners in the middle of its sides, so that neighbours meet it edge to edge', () => {
    const points = [
      [0, 0],
      [1, 0],
      [2, 0],
      [4, 0],
      [4, 1],
      [1, 1],
      [1, 2.5],
      [1, 4],
      [0, 4],
      [0, 3],
      [0, 1],
    ];
    for (let first = 0; first < points.length; first++) {
      const turned = [...points.slice(first), ...points.slice(0, first)];
      const triangles = cut(turned);
      expect(new Set(triangles).size).toBe(points.length);
      expect(areaOf(turned, triangles)).toBeCloseTo(7, 9);
    }
  });

  test('a polygon without area gives no triangles, and one with a NaN corner gives a fan', () => {
    expect(triangulatePolygon([0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3])).toEqual([]);
    expect(triangulatePolygon([5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5])).toEqual([]);
    expect(triangulatePolygon([0, 0, 0, 1, 1, 1])).toEqual([]);
    expect(triangulatePolygon([0, 0, 0, NaN, 0, 0, 1, 1, 0, 0, 1, 0])).toHaveLength(6);
  });
});
