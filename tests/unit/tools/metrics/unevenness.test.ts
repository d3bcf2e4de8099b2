import { expect, test } from 'vitest';
import type { SurfaceImage } from '../../../../tools/metrics/measures/SurfaceImage.js';
import { unevenness } from '../../../../tools/metrics/measures/unevenness.js';

const SIZE = 120;
const draw = (luminanceAt: (x: number, y: number) => number): SurfaceImage => ({
  width: SIZE,
  height: SIZE,
  luminance: Float32Array.from({ length: SIZE * SIZE }, (_, i) => luminanceAt(i % SIZE, Math.floor(i / SIZE))),
  surface: new Uint8Array(SIZE * SIZE).fill(1),
});

test('an even grey and fine even lines are even', () => {
  expect(
    unevenness(
      draw(() => 0.5),
      8,
    ),
  ).toBeLessThan(1e-6);
  expect(
    unevenness(
      draw((x) => x % 2),
      8,
    ),
  ).toBeLessThan(1e-3);
});

test('two halves that differ by a tenth deviate by half of that', () => {
  const halves = draw((x) => (x < SIZE / 2 ? 0.5 : 0.6));
  expect(unevenness(halves, 1)).toBeCloseTo(0.05, 2);
});

test('bands narrower than the blur count less than broad ones', () => {
  const bands = (period: number) =>
    unevenness(
      draw((x) => (x % period < period / 2 ? 0.4 : 0.6)),
      8,
    );
  expect(bands(8)).toBeLessThan(bands(30));
});
