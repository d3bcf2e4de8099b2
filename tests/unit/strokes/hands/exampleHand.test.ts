import { describe, expect, test } from 'vitest';
import { checkHand } from '../../../../src/strokes/hand/checkHand.js';
import type { HandNumbers } from '../../../../src/strokes/hand/Hand.js';
import { exampleHabits } from '../../../../src/strokes/hands/exampleHabits.js';
import { exampleHand, exampleHandNames } from '../../../../src/strokes/hands/exampleHand.js';

describe.each(exampleHandNames)('%s', (name) => {
  const hand = exampleHand(name);

  test('is a valid hand, and survives JSON', () => {
    expect(() => checkHand('test', hand)).not.toThrow();
    expect(JSON.parse(JSON.stringify(hand))).toEqual(hand);
  });

  test('has five strokes or more in each swatch, and darker swatches have more ink', () => {
    const inks = (['light', 'middle', 'dark'] as const).map((tone) => {
      const strokes = hand.strokes.filter(({ swatch }) => swatch === tone);
      expect(strokes.length).toBeGreaterThanOrEqual(tone === 'light' ? 3 : 5);
      return strokes.length;
    });
    expect(inks[1]).toBeGreaterThan(1.15 * inks[0]);
    expect(inks[2]).toBeGreaterThan(1.15 * inks[1]);
  });

  test('the same seed gives the same strokes, another seed others in the same manner', () => {
    expect(exampleHand(name)).toEqual(hand);
    const other = exampleHand(name, { seed: 2 });
    expect(other.strokes).not.toEqual(hand.strokes);
    const { length, width } = other.numbers;
    expect(length / hand.numbers.length).toBeCloseTo(1, 0);
    expect(Math.abs(width / hand.numbers.width - 1)).toBeLessThan(0.15);
  });

  test('the learnt numbers are those it was drawn with', () => {
    const { length, taperEnd, curvature, crossing } = exampleHabits[name] as (typeof exampleHabits)['finePen'];
    const { numbers } = hand;
    expect(Math.abs(numbers.length / length - 1)).toBeLessThan(0.2);
    expect(Math.abs(numbers.taperEnd - taperEnd)).toBeLessThan(0.15);
    expect(Math.abs(numbers.curvature - curvature)).toBeLessThan(0.035);
    expect(numbers.crossingFrom < 1).toBe(crossing !== undefined);
    if (!crossing) return;
    const turn = Math.abs(numbers.crossingAngle - crossing.angle) % 180;
    expect(Math.min(turn, 180 - turn)).toBeLessThan(4);
  });
});

test('ruled strokes are straight, even and blunt, unlike a scribble', () => {
  const numbers = (name: 'ruled' | 'scribble'): HandNumbers => exampleHand(name).numbers;
  const [ruled, scribble] = [numbers('ruled'), numbers('scribble')];
  for (const number of ['wobble', 'angleSpread', 'spacingSpread', 'lengthSpread'] as const) {
    expect(ruled[number], number).toBeLessThan(0.1 * scribble[number]);
  }
  expect([ruled.taperStart, ruled.taperEnd]).toEqual([0, 0]);
});

test('a wrong name or seed throws an error with the remedy', () => {
  expect(() => exampleHand('quill' as never)).toThrow(
    /^exampleHand: there is no hand "quill"; use one of finePen, brush, .*\.$/,
  );
  expect(() => exampleHand('toString' as never)).toThrow(/there is no hand "toString"/);
  expect(() => exampleHand('brush', { seed: 0.5 })).toThrow(/seed is 0.5, but must be a whole number/);
});
