import { describe, expect, test } from 'vitest';
import { discRing, penDotRing, ringLength } from '../../../src/vector/paths/finishDots.js';

const PEN = 0.3;

/** The distance of a point from a closed polyline. */
function distance(ring: readonly (readonly [number, number])[], x: number, y: number): number {
  return Math.min(
    ...ring.map(([ax, ay], i) => {
      const [bx, by] = ring[(i + 1) % ring.length];
      const [dx, dy] = [bx - ax, by - ay];
      const square = dx * dx + dy * dy;
      const t = square > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / square, 0), 1) : 0;
      return Math.hypot(x - ax - t * dx, y - ay - t * dy);
    }),
  );
}

describe('a dot of a pen', () => {
  test.each([0.1, 0.16, 0.2, 0.3, 0.35, 0.6, 1.3])('of radius %f is inked all over, and not outside', (radius) => {
    const ring = penDotRing({ x: 20, y: 30, radius }, PEN);
    const drawn = Math.max(radius, PEN / 2 + 0.02);
    const step = drawn / 12;
    for (let x = -1.5 * drawn; x <= 1.5 * drawn; x += step) {
      for (let y = -1.5 * drawn; y <= 1.5 * drawn; y += step) {
        const away = Math.hypot(x, y);
        const isInked = distance(ring, 20 + x, 30 + y) <= PEN / 2;
        // Its sides are chords, up to 0.01 mm inside the circle, and its corners half as much outside.
        if (away < drawn - 0.011) expect(isInked, `${away} of ${drawn}`).toBe(true);
        if (away > drawn + 0.005) expect(isInked, `${away} of ${drawn}`).toBe(false);
      }
    }
  });

  test('is one short way around, unless that leaves its middle blank', () => {
    expect(ringLength(penDotRing({ x: 0, y: 0, radius: 0.1 }, PEN))).toBeCloseTo(2 * Math.PI * 0.02, 2);
    const circle = 2 * Math.PI * (0.29 - PEN / 2);
    expect(ringLength(penDotRing({ x: 0, y: 0, radius: 0.29 }, PEN))).toBeCloseTo(circle, 1);
    expect(ringLength(penDotRing({ x: 0, y: 0, radius: 0.6 }, PEN))).toBeGreaterThan(2 * circle);
  });
});

test('a disc of a print has the area of the dot', () => {
  for (const radius of [0.02, 0.1, 0.5, 3]) {
    const ring = discRing({ x: 1, y: 2, radius });
    const area = ring.reduce((sum, [x, y], i) => {
      const [nextX, nextY] = ring[(i + 1) % ring.length];
      return sum + 0.5 * (x * nextY - nextX * y);
    }, 0);
    expect(area / (Math.PI * radius ** 2)).toBeCloseTo(1, 9);
  }
});
