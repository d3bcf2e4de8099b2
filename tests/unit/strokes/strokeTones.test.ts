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

test('two lanes on one row whose strokes lie over each other are as dark as one of them', () => {
  const over = dark(tonesOf(0.8, { offset: 1e-6, both: 0.8 }));
  const one = dark(tonesOf(0.8, { offset: 0, both: 0 }));
  // Where some are not there yet, those of the other lane may be.
  const all = one.map((widening, i) => [widening, over[i]]).filter(([widening]) => widening > 0.05);
  expect(all.length).toBeGreaterThan(10);
  for (const [widening, ofOver] of all) expect(Math.abs(ofOver - widening)).toBeLessThan(0.03);
});
