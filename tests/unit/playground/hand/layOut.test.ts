import { expect, test } from 'vitest';
import { layOut } from '../../../../src/playground/hand/swatches.js';
import type { HandStroke } from '../../../../src/strokes/hand/Hand.js';

const line = (x: number, y: number, length: number, swatch?: HandStroke['swatch']): HandStroke => ({
  points: [x, y, x + length, y],
  widths: [0.4, 0.2],
  ...(swatch && { swatch }),
});

test('strokes that lie in their fields stay as they are', () => {
  const strokes = [line(5, 5, 20, 'light'), line(5, 30, 20), line(5, 60, 20, 'dark')];
  expect(layOut(strokes)).toBe(strokes);
});

test('swatches beside each other come to lie in their fields, in their middles, as large as they were', () => {
  const strokes = [line(2, 3, 10, 'light'), line(2, 9, 10, 'light'), line(24, 5, 12), line(46, 8, 10, 'dark')];
  const laid = layOut(strokes);
  expect(laid.map(({ points }) => points)).toEqual([
    [33, 9, 43, 9],
    [33, 15, 43, 15],
    [32, 36, 44, 36],
    [33, 60, 43, 60],
  ]);
  expect(laid.map(({ widths }) => widths)).toEqual(strokes.map(({ widths }) => widths));
  expect(layOut(laid)).toBe(laid);
});

test('strokes larger than their field are shrunk with their widths, in all swatches alike', () => {
  const strokes = [line(0, 0, 148, 'light'), line(0, 100, 10, 'dark')];
  expect(layOut(strokes)).toEqual([
    { points: [1, 12, 75, 12], widths: [0.2, 0.1], swatch: 'light' },
    { points: [35.5, 60, 40.5, 60], widths: [0.2, 0.1], swatch: 'dark' },
  ]);
});
