import { expect, test } from 'vitest';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { traceStrokes } from '../../../src/worker/handsAsync.js';
import { photograph, straight } from '../strokes/strokeTracing/paper.js';
import { trace } from '../strokes/strokeTracing/trace.js';

const image = photograph(
  [0, 1, 2, 3, 4, 5].map((i) => straight(120, 30 + 24 * i, 160, -12, 5)),
  { width: 240, height: 180, noise: 5 },
);

test('gives what its steps give, with progress, and leaves the picture as it is', async () => {
  const before = image.data.slice();
  const progress: number[] = [];
  const strokes = await traceStrokes(image, { swatch: 'dark', onProgress: (value) => progress.push(value) });
  expect(strokes).toEqual(trace(image, { swatch: 'dark' }));
  expect(image.data).toEqual(before);
  expect(progress.at(-1)).toBe(1);
  expect(progress).toEqual(progress.toSorted((a, b) => a - b));
});

test('learnHand takes what was traced', async () => {
  const { numbers, strokes } = learnHand(await traceStrokes(image, { millimetresPerPixel: 0.1 }));
  expect(strokes).toHaveLength(6);
  expect(Math.abs(numbers.length / 16 - 1)).toBeLessThan(0.1);
  expect(Math.abs(numbers.width / 0.5 - 1)).toBeLessThan(0.1);
  expect(Math.abs(numbers.spacing / (2.4 * Math.cos((12 * Math.PI) / 180)) - 1)).toBeLessThan(0.1);
  expect(numbers.angleSpread).toBeLessThan(1);
});

test('stops when it is aborted', async () => {
  const controller = new AbortController();
  const reason = new Error('enough');
  const promise = traceStrokes(image, { signal: controller.signal, onProgress: () => controller.abort(reason) });
  await expect(promise).rejects.toBe(reason);
});

test('refuses with a sentence', async () => {
  const blank = { width: 40, height: 40, data: new Uint8Array(1600).fill(250) };
  await expect(traceStrokes(blank)).rejects.toThrow(/^traceStrokes: no strokes were found in the picture/);
  await expect(traceStrokes(undefined as never)).rejects.toThrow(/^traceStrokes: expected a picture/);
  await expect(traceStrokes(blank, { scale: 1 } as never)).rejects.toThrow(/unknown option "scale"/);
});
