import { expect, it } from 'vitest';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { learnHandAsync } from '../../../src/worker/handsAsync.js';
import { drawSwatch } from '../strokes/hand/drawSwatch.js';

const strokes = drawSwatch({ rows: 120, taperEnd: 0.3, angleSpread: 3 });

it('learns what learnHand learns, and tells how far it is', async () => {
  const progress: number[] = [];
  const hand = await learnHandAsync(strokes, { name: 'mine', onProgress: (done) => progress.push(done) });
  expect(hand).toEqual(learnHand(strokes, { name: 'mine' }));
  expect(progress).toEqual(progress.toSorted((a, b) => a - b));
  expect(progress.at(-1)).toBeGreaterThan(0.5);
});

it('ends in a sentence', async () => {
  await expect(learnHandAsync([])).rejects.toThrow('learnHand: there are no strokes; draw at least one.');
  await expect(learnHandAsync(strokes, { strokes } as never)).rejects.toThrow('unknown option "strokes"');
  await expect(learnHandAsync(strokes, { signal: AbortSignal.abort(new Error('stop')) })).rejects.toThrow('stop');
});
