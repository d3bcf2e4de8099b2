import { expect, test } from 'vitest';
import { changedNumbers, learnOwnHand, withNumbers } from '../../../../src/playground/hand/ownHand.js';
import type { HandStroke } from '../../../../src/strokes/hand/Hand.js';

const strokes: HandStroke[] = Array.from({ length: 8 }, (_, i) => {
  const shares = Array.from({ length: 12 }, (_, k) => k / 11);
  return {
    points: shares.flatMap((share) => [6 + 4 * i + 5 * share, 45 - 15 * share + 0.2 * (i % 3)]),
    widths: shares.map((share) => 0.2 + 0.4 * Math.sin(Math.PI * (0.1 + 0.8 * share))),
    swatch: 'middle',
  };
});

test('from five strokes on there is a hand; the strokes stay as they were drawn', () => {
  expect(learnOwnHand([], {})).toBeUndefined();
  expect(learnOwnHand(strokes.slice(0, 4), {})!.hand).toBeUndefined();
  const own = learnOwnHand(strokes.slice(0, 5), {})!;
  expect(own.strokes).toEqual(strokes.slice(0, 5));
  expect(own.hand!.numbers.length).toBeCloseTo(Math.hypot(5, 15), 1);
  expect([own.link, own.files]).not.toContain(undefined);
});

test('nothing is learnt from dots', () => {
  const dots = Array.from({ length: 6 }, (_, i) => ({ points: [5 * i, 30, 5 * i + 0.1, 30], widths: [1, 1] }));
  expect(learnOwnHand(dots, {})!.hand).toBeUndefined();
});

test('changed numbers stay when more is drawn, and are recognised in a hand that was read', () => {
  const own = withNumbers(learnOwnHand(strokes.slice(0, 6), {})!, { wobble: 0.5, crossingAngle: 40 });
  const more = learnOwnHand(strokes, own.changed!)!;
  expect(more.hand!.numbers).toMatchObject({ wobble: 0.5, crossingAngle: 40 });
  expect(changedNumbers(JSON.parse(JSON.stringify(more.hand)))).toEqual({ wobble: 0.5, crossingAngle: 40 });
});
