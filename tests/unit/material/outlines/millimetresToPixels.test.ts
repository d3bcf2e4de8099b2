import { expect, test } from 'vitest';
import { millimetresToPixels } from '../../../../src/material/outlines/outlineProperties.js';

test.each([
  [25.4, 300, 300],
  [0.254, 600, 6],
  [0.25, 600, 5.905511811],
  [1, 25.4, 1],
])('%f mm at %f dpi are %f pixels', (millimetres, dpi, pixels) => {
  expect(millimetresToPixels(millimetres, dpi)).toBeCloseTo(pixels, 8);
});

test.each([
  [0, 300],
  [-1, 300],
  [-1, -300],
  [1, 0],
  [Number.NaN, 300],
  [1, Number.NaN],
  [Infinity, 300],
  [1, Infinity],
  [Infinity, 0],
  [undefined as unknown as number, 300],
])('%f mm at %f dpi are refused', (millimetres, dpi) => {
  const act = () => millimetresToPixels(millimetres, dpi);
  expect(act).toThrow(RangeError);
  expect(act).toThrow(`millimetresToPixels: ${millimetres} mm at ${dpi} dpi. Pass two positive numbers`);
});
