import { expect, test } from 'vitest';
import { eraseStrokes } from '../../../../src/playground/hand/swatches.js';

const level = { points: [0, 0, 10, 0, 20, 0], widths: [0.2, 2, 0.2] };
const steep = { points: [15, -10, 15, 10], widths: [0.4, 0.4] };

test('a rubber takes the strokes that it touches, with their width, and no others', () => {
  expect(eraseStrokes([level, steep], 5, 0.3, 0.5)).toEqual([steep]);
  expect(eraseStrokes([level, steep], 15, 0, 0.5)).toEqual([]);
  expect(eraseStrokes([level, steep], 15, 8, 0.1)).toEqual([level]);
  // In its middle the stroke reaches a millimetre up, at its end not.
  expect(eraseStrokes([level], 10, 1.4, 0.5)).toEqual([]);
  expect(eraseStrokes([level], 0, 1.4, 0.5)).toEqual([level]);
});

test('strokes that the rubber does not touch stay the same array', () => {
  const strokes = [level, steep];
  expect(eraseStrokes(strokes, 30, 30, 1)).toBe(strokes);
  expect(eraseStrokes([], 0, 0, 1)).toEqual([]);
});
