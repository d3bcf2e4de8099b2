import { expect, test } from 'vitest';
import { type PenSample, StrokeRecorder } from '../../../../src/playground/hand/StrokeRecorder.js';

const PEN_WIDTH = 0.4;
const record = () => new StrokeRecorder(() => PEN_WIDTH);

const sample = (given: Partial<PenSample>): PenSample => ({
  ...{ pointerId: 1, kind: 'pen', x: 10, y: 10, pressure: 0.5, tilt: 0, time: 0 },
  ...given,
});

/** Draws from left to right, a millimetre every `milliseconds`, and returns the stroke. */
function draw(recorder: StrokeRecorder, given: Partial<PenSample> = {}, milliseconds = 10, count = 10) {
  const { pointerId } = sample(given);
  recorder.start(sample(given));
  for (let i = 1; i <= count; i++) {
    recorder.move(sample({ ...given, x: 10 + i, time: (given.time ?? 0) + i * milliseconds }));
  }
  return recorder.end(pointerId);
}

test('a pen draws the points it went through, as wide as it is pressed', () => {
  const recorder = record();
  recorder.start(sample({ pressure: 0 }));
  recorder.move(sample({ x: 13, y: 14, pressure: 0.5, time: 10 }));
  recorder.move(sample({ x: 16, y: 18, pressure: 1, time: 20 }));
  const stroke = recorder.end(1)!;
  expect(stroke.points).toEqual([10, 10, 13, 14, 16, 18]);
  const [none, half, all] = stroke.widths;
  expect([none < 0.3 * PEN_WIDTH, half > 0.9 * PEN_WIDTH, half < 1.2 * PEN_WIDTH, all > 1.7 * PEN_WIDTH]).toEqual([
    true,
    true,
    true,
    true,
  ]);
});

test('a tilted pen is wider, up to its greatest tilt', () => {
  const widthAt = (tilt: number): number => draw(record(), { tilt })!.widths[0];
  expect(widthAt(20)).toBe(widthAt(0));
  expect(widthAt(55)).toBeGreaterThan(1.3 * widthAt(0));
  expect(widthAt(90)).toBe(widthAt(75));
});

test('a mouse draws thinner where it is fast, whatever pressure it claims', () => {
  const slow = draw(record(), { kind: 'mouse' }, 50)!;
  const fast = draw(record(), { kind: 'mouse' }, 2)!;
  expect(slow.widths.at(-1)).toBeGreaterThan(1.6 * fast.widths.at(-1)!);
  expect(draw(record(), { kind: 'mouse', pressure: 1 }, 50)).toEqual(slow);
  expect(draw(record(), { kind: 'touch', pressure: 0 }, 50)).toEqual(slow);
});

test('a stroke belongs to the field in which its middle lies', () => {
  expect([5, 30, 60].map((y) => draw(record(), { y })!.swatch)).toEqual(['light', 'middle', 'dark']);
});

test('a tap is no stroke, and a trembling pen at rest adds no points', () => {
  const recorder = record();
  recorder.start(sample({}));
  for (let i = 0; i < 50; i++) recorder.move(sample({ x: 10 + 0.1 * (i % 2), time: i }));
  expect(recorder.drawn).toBeUndefined();
  expect(recorder.end(1)).toBeUndefined();
});

test('points beyond the sheet are drawn at its edge', () => {
  const recorder = record();
  recorder.start(sample({ x: -5, y: 60 }));
  recorder.move(sample({ x: 500, y: 500, time: 10 }));
  expect(recorder.end(1)!.points).toEqual([0, 60, 76, 72]);
});

test('the palm is ignored while a pen draws and for a moment after', () => {
  const recorder = record();
  const finger = { pointerId: 7, kind: 'touch' } as const;
  // The palm is down before the pen.
  recorder.start(sample({ ...finger, time: 0 }));
  recorder.move(sample({ ...finger, x: 30, time: 10 }));
  expect(recorder.start(sample({ time: 20 }))).toBe(true);
  expect(recorder.start(sample({ ...finger, pointerId: 8, time: 30 }))).toBe(false);
  recorder.move(sample({ ...finger, x: 60, time: 35 }));
  recorder.move(sample({ x: 20, time: 40 }));
  expect(recorder.end(7)).toBeUndefined();
  expect(recorder.end(1)!.points).toEqual([10, 10, 20, 10]);
  expect(recorder.start(sample({ ...finger, pointerId: 9, time: 900 }))).toBe(false);
  expect(draw(recorder, { ...finger, pointerId: 10, time: 2000 })).toBeDefined();
});

test('a second finger cancels the stroke of the first, until both are lifted', () => {
  const recorder = record();
  const finger = (pointerId: number, x: number, time: number) => sample({ kind: 'touch', pointerId, x, time });
  expect(recorder.start(finger(1, 10, 0))).toBe(true);
  recorder.move(finger(1, 20, 10));
  expect(recorder.start(finger(2, 40, 20))).toBe(false);
  recorder.move(finger(1, 30, 30));
  expect([recorder.end(1), recorder.end(2)]).toEqual([undefined, undefined]);
  expect(draw(recorder, { kind: 'touch', pointerId: 3 })).toBeDefined();
});

test('a pointer cancelled by the browser leaves no stroke, and the next one draws', () => {
  const recorder = record();
  recorder.start(sample({}));
  recorder.move(sample({ x: 30, time: 10 }));
  recorder.cancel(1);
  expect(recorder.end(1)).toBeUndefined();
  expect(draw(recorder)).toBeDefined();
});

test('another button, or another mouse, begins no stroke while one is drawn', () => {
  const recorder = record();
  recorder.start(sample({ kind: 'mouse' }));
  recorder.move(sample({ kind: 'mouse', x: 20, time: 10 }));
  expect(recorder.start(sample({ kind: 'mouse', pointerId: 2, time: 20 }))).toBe(false);
  expect(recorder.end(1)!.points).toEqual([10, 10, 20, 10]);
});
