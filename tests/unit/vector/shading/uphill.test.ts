import { expect, test } from 'vitest';
import { dot, normalize, type Vec3 } from '../../../../src/look/vectors.js';
import { type Mat3, screenMap, uphillOnPicture } from '../../../../src/vector/shading/screenGradient.js';
import { randomNumbers } from '../randomNumbers.js';

const SAME: Mat3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

test.each([false, true])(
  'a function rises uphill on the picture, and stays the same across, orthographic: %s',
  (isOrthographic) => {
    const random = randomNumbers(31);
    const vector = (): Vec3 => [random() - 0.5, random() - 0.5, random() - 0.5];
    let fronts = 0;
    for (let i = 0; i < 200; i++) {
      const normal = normalize(vector());
      const gradient = vector();
      const view: Vec3 = [random() - 0.5, random() - 0.5, -1 - random()];
      const map = screenMap(normal, SAME, { view, isOrthographic, unitsPerPixel: 1e-3 }, true);
      const [cx, cy] = isOrthographic ? [0, 0] : [view[0] / view[2], view[1] / view[2]];
      // The rise of the function over a step on the surface that is the given step on the picture, whose y runs down.
      const rise = ([dx, dy]: readonly [number, number]): number => {
        const tz = -(dx * normal[0] - dy * normal[1]) / dot(normal, [cx, cy, 1]);
        return dot(gradient, [dx + cx * tz, -dy + cy * tz, tz]);
      };
      const [x, y] = uphillOnPicture(gradient, map);
      expect(Math.hypot(x, y)).toBeCloseTo(1, 9);
      expect(rise([x, y])).toBeGreaterThan(0);
      expect(Math.abs(rise([y, -x]))).toBeLessThan(1e-6 * rise([x, y]));
      if (dot(normal, [cx, cy, 1]) > 0) fronts++;
    }
    expect(fronts).toBeGreaterThan(50);
    expect(fronts).toBeLessThan(150);
  },
);
