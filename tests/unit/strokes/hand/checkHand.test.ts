import { describe, expect, it } from 'vitest';
import { checkHand } from '../../../../src/strokes/hand/checkHand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { random } from '../../../../src/strokes/random.js';
import { drawSwatch } from './drawSwatch.js';

const hand = learnHand(drawSwatch({}));

describe('checkHand', () => {
  it('accepts what learnHand makes, from JSON too, whatever the strokes', () => {
    expect(() => checkHand('f', JSON.parse(JSON.stringify(hand)))).not.toThrow();
    const next = random(5);
    for (let i = 0; i < 40; i++) {
      const strokes = Array.from({ length: 1 + Math.floor(12 * next()) }, () => {
        const count = 2 + Math.floor(20 * next());
        return {
          points: Array.from({ length: 2 * count }, () => 10_000 * (2 * next() - 1) ** 9),
          widths: Array.from({ length: count }, () => 0.001 + 3 * next() ** 4),
        };
      });
      expect(() => checkHand('f', learnHand(strokes))).not.toThrow();
    }
  });

  it.each<[unknown, string]>([
    [null, 'f: hand is null, but must be { version, strokes, numbers }; learnHand makes one from strokes.'],
    [[], 'f: hand is an array, but must be { version, strokes, numbers }; learnHand makes one from strokes.'],
    [{ ...hand, version: 2 }, 'f: hand.version is 2, but must be 1.'],
    [{ ...hand, name: 1 }, 'f: hand.name is 1, but must be a text, or left out.'],
    [{ ...hand, strokes: [] }, 'f: hand: there are no strokes; draw at least one.'],
    [{ ...hand, numbers: undefined }, 'f: hand.numbers is undefined, but must be an object with the learnt numbers.'],
    [
      { ...hand, numbers: { ...hand.numbers, overlap: '1' } },
      'f: hand.numbers.overlap is 1, but must be a number from -2 to 1.',
    ],
    [
      { ...hand, numbers: { ...hand.numbers, width: Number.NaN } },
      'f: hand.numbers.width is NaN, but must be a number from 0.001 to 10000.',
    ],
  ])('refuses %s', (value, sentence) => {
    expect(() => checkHand('f', value)).toThrow(sentence);
  });
});
