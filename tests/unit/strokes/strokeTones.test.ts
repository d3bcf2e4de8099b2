import { expect, test } from 'vitest';
import { HAND_TEXTURE } from '../../../src/strokes/handConstants.js';
import { drawnTones } from '../../../src/strokes/strokeTones.js';

const { PLACES } = HAND_TEXTURE;

/** A straight stroke on its row, a third as wide as rows are apart. */
const stroke = Float32Array.from({ length: 2 * PLACES }, (_, i) => (i % 2 === 0 ? 0 : 1 / 6));

/** The tones drawn by that stroke, where no young row is there. */
const tonesOf = (filled: number, lanes: { offset: number; both: number }) =>
  drawnTones(stroke, filled, 1, 2, 0, lanes)[0];

/** How each tone is drawn that needs all strokes. */
const dark = (tones: ReturnType<typeof tonesOf>) => tones.map(({ share, widening }) => (share === 1 ? widening : 0));

test('two lanes on one row whose strokes take turns are as dark as one lane without gaps', () => {
  const inTurns = dark(tonesOf(0.5, { offset: 1e-6, both: 0 }));
  const whole = dark(tonesOf(1, { offset: 0, both: 0 }));
  expect(inTurns.filter((widening) => widening > 0).length).toBeGreaterThan(20);
  for (const [i, widening] of inTurns.entries()) expect(widening).toBeCloseTo(whole[i], 6);
});

test('two lanes on one row whose strokes lie over each other cover what one lane with strokes of either covers', () => {
  const over = tonesOf(0.8, { offset: 1e-6, both: 0.8 });
  const one = tonesOf(0.8, { offset: 0, both: 0 });
  const pairs = one.map(({ share }, i) => [share, over[i].share]).filter(([share]) => share > 0 && share < 0.95);
  expect(pairs.length).toBeGreaterThan(10);
  for (const [share, ofOver] of pairs) expect(Math.abs(1 - (1 - ofOver) ** 2 - share)).toBeLessThan(0.01);
});
