import { describe, expect, test } from 'vitest';
import { Bvh, CASTS_BACK, SEEN_BACK, SEEN_FRONT } from '../../../src/vector/Bvh.js';
import { finished } from './finished.js';
import { randomNumbers } from './randomNumbers.js';

type Point = readonly [number, number, number];

const random = randomNumbers(5);
const point = (): Point => [random() - 0.5, random() - 0.5, random() - 0.5];

/** Many small triangles and a few large ones, with all combinations of sides. */
function triangles(count: number): { corners: Float64Array; sides: Uint8Array } {
  const corners: number[] = [];
  const sides: number[] = [];
  for (let i = 0; i < count; i++) {
    const centre = point();
    const size = i % 50 === 0 ? 1 : 0.06;
    for (let k = 0; k < 3; k++) corners.push(...point().map((x, axis) => centre[axis] + size * x));
    sides.push([SEEN_FRONT, SEEN_BACK, SEEN_FRONT | SEEN_BACK, CASTS_BACK][i % 4]);
  }
  return { corners: Float64Array.from(corners), sides: Uint8Array.from(sides) };
}

/**
 * The distance of the hit with each triangle along a ray, and whether it is on the front: by planes and areas, which the hierarchy does not
 * use.
 */
function metBy(corners: Float64Array, origin: Point, way: Point) {
  const met: { triangle: number; t: number; isFront: boolean }[] = [];
  const at = (t: number, k: number): Point => [
    corners[9 * t + 3 * k],
    corners[9 * t + 3 * k + 1],
    corners[9 * t + 3 * k + 2],
  ];
  const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const crossed = (a: Point, b: Point): Point => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  for (let t = 0; t < corners.length / 9; t++) {
    const [a, b, c] = [at(t, 0), at(t, 1), at(t, 2)];
    const normal = crossed(minus(b, a), minus(c, a));
    const speed = dot(normal, way);
    const place = dot(normal, minus(a, origin)) / speed;
    const p = origin.map((x, i) => x + place * way[i]) as unknown as Point;
    const isInside = [
      [a, b],
      [b, c],
      [c, a],
    ].every(([u, v]) => dot(crossed(minus(v, u), minus(p, u)), normal) >= 0);
    if (isInside && speed !== 0) met.push({ triangle: t, t: place, isFront: speed < 0 });
  }
  return met;
}

describe('rays hit the same triangles as a test of all triangles', async () => {
  const { corners, sides } = triangles(600);
  const bvh = finished(Bvh.build(corners, sides));
  const counts = (triangle: number, isFront: boolean, front: number, back: number) =>
    (sides[triangle] & (isFront ? front : back)) !== 0;

  test('hits that hide a place from an eye at the far end, and hits that shade it', () => {
    let hidden = 0;
    for (let i = 0; i < 2000; i++) {
      const [origin, way] = [point(), point()];
      const met = metBy(corners, origin, way).filter(({ t }) => t > 0.001 && t < 1);
      // A front that is hit from behind faces the far end.
      const seen = met.filter(({ triangle, isFront }) => counts(triangle, isFront, SEEN_BACK, SEEN_FRONT));
      expect(bvh.isHidden(origin, way, 0.001, 1)).toBe(seen.length > 0);
      if (seen.length === 1) expect(bvh.isHidden(origin, way, 0.001, 1, seen[0].triangle)).toBe(false);
      expect(bvh.isShaded(origin, way, 0.001, 1)).toBe(
        met.some(({ triangle, isFront }) => counts(triangle, isFront, CASTS_BACK, 4)),
      );
      hidden += Number(seen.length > 0);
    }
    expect(hidden).toBeGreaterThan(200);
    expect(hidden).toBeLessThan(1800);
  });

  test('the first visible hit', () => {
    for (let i = 0; i < 1000; i++) {
      const [origin, way] = [point(), point()];
      const first = metBy(corners, origin, way)
        .filter(({ triangle, t, isFront }) => t > 0.01 && counts(triangle, isFront, SEEN_FRONT, SEEN_BACK))
        .reduce((least, { t }) => Math.min(least, t), Infinity);
      const found = bvh.firstMet(origin, way, 0.01);
      if (first === Infinity) expect(found).toBe(Infinity);
      else expect(found).toBeCloseTo(first, 9);
    }
  });
});

test('an empty scene hides nothing, and flat boxes are hit', () => {
  const empty = finished(Bvh.build(new Float64Array(), new Uint8Array()));
  expect(empty.firstMet([0, 0, 0], [0, 0, 1], 0)).toBe(Infinity);
  const flat = Float64Array.of(-1, -1, 0, 1, -1, 0, 0, 1, 0);
  const bvh = finished(Bvh.build(flat, Uint8Array.of(SEEN_FRONT)));
  expect(bvh.firstMet([0, 0, 5], [0, 0, -1], 0)).toBeCloseTo(5, 12);
  expect(bvh.firstMet([0, 0, -5], [0, 0, 1], 0)).toBe(Infinity);
});

test('triangles that all lie at one place do not end the build', () => {
  const corners = Float64Array.from({ length: 9 * 500 }, (_, i) => [0, 0, 0, 1, 0, 0, 0, 1, 0][i % 9]);
  const bvh = finished(Bvh.build(corners, new Uint8Array(500).fill(SEEN_FRONT)));
  expect(bvh.firstMet([0.2, 0.2, 1], [0, 0, -1], 0)).toBeCloseTo(1, 12);
});
