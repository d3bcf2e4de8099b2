import { describe, expect, test } from 'vitest';
import { createSeenMap, drawSeenMap, MAP_SIZE, NOTHING } from '../../../../src/viewer/views/seenMap.js';
import { type ViewSurface, viewSurface } from '../../../../src/viewer/views/viewSurface.js';

/** A repeatable sequence of numbers in [0, 1). */
function randomNumbers(): () => number {
  let state = 1;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** Triangles at random places, whose sides are about as long as a number of pixels. */
function scattered(count: number, pixels: number): ViewSurface {
  const random = randomNumbers();
  const size = (2 * pixels) / MAP_SIZE;
  const positions = Array.from({ length: count }, () => {
    const middle = [0, 1, 2].map(() => random() - 0.5);
    return [0, 1, 2].flatMap(() => middle.map((value) => value + size * (random() - 0.5)));
  }).flat();
  return viewSurface({ positions, indices: null, isSingleSided: null }, 'y');
}

/** The nearest triangle at the middle of each pixel from +z, found by trying all. */
function nearestByAll({ positions }: ViewSurface): number[] {
  return Array.from({ length: MAP_SIZE ** 2 }, (_, pixel) => {
    const x = (2 * ((pixel % MAP_SIZE) + 0.5)) / MAP_SIZE - 1;
    const y = (2 * (Math.floor(pixel / MAP_SIZE) + 0.5)) / MAP_SIZE - 1;
    let [nearest, found] = [-Infinity, NOTHING];
    for (let i = 0; i < positions.length; i += 9) {
      const [ax, ay, az, bx, by, bz, cx, cy, cz] = positions.subarray(i, i + 9);
      const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
      const b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area;
      const c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area;
      const z = (1 - b - c) * az + b * bz + c * cz;
      if (b >= 0 && c >= 0 && b + c <= 1 && z > nearest) [nearest, found] = [z, i / 9];
    }
    return found;
  });
}

describe('a map shows the nearest triangle at the middle of each pixel', () => {
  test.each([2, 8, 60])('of triangles about %i pixels wide', (pixels) => {
    const surface = scattered(100, pixels);
    const map = createSeenMap(surface);
    drawSeenMap(map, surface, 0, 0);
    const expected = nearestByAll(surface);
    const covered = expected.filter((triangle) => triangle !== NOTHING).length;
    expect(covered).toBeGreaterThan(20);
    // Rounding may decide otherwise on an edge.
    const wrong = expected.filter((triangle, pixel) => triangle !== map.triangles[pixel]).length;
    expect(wrong).toBeLessThanOrEqual(covered / 500);
  });
});

test('the back of a single-sided triangle is not drawn', () => {
  const positions = [-1, -1, 0, 1, -1, 0, 0, 1, 0];
  const surface = viewSurface({ positions, indices: null, isSingleSided: Uint8Array.of(1) }, 'y');
  const map = createSeenMap(surface);
  const isEmpty = (azimuth: number): boolean => {
    drawSeenMap(map, surface, azimuth, 0);
    return map.triangles.every((triangle) => triangle === NOTHING);
  };
  expect(isEmpty(0)).toBe(false);
  expect(isEmpty(180)).toBe(true);
});
