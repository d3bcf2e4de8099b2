import { describe, expect, test } from 'vitest';
import { checkHand } from '../../../../src/strokes/hand/checkHand.js';
import type { HandNumbers, HandStroke } from '../../../../src/strokes/hand/Hand.js';
import { exampleHabits, type PenHabits } from '../../../../src/strokes/hands/exampleHabits.js';
import { type ExampleHandName, exampleHand, exampleHandNames } from '../../../../src/strokes/hands/exampleHand.js';

describe.each(exampleHandNames)('%s', (name) => {
  const hand = exampleHand(name);

  test('is a valid hand, and survives JSON', () => {
    expect(() => checkHand('test', hand)).not.toThrow();
    expect(JSON.parse(JSON.stringify(hand))).toEqual(hand);
  });

  test('has five strokes or more in each swatch, and darker swatches have more ink', () => {
    const inks = (['light', 'middle', 'dark'] as const).map((tone) => {
      const strokes = hand.strokes.filter(({ swatch }) => swatch === tone);
      expect(strokes.length).toBeGreaterThanOrEqual(5);
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
    expect(Math.abs(width / hand.numbers.width - 1)).toBeLessThan(0.2);
  });

  test('the learnt numbers are those it was drawn with', () => {
    const { length, taperEnd, curvature, crossing, skips, hooks, isZigzag }: PenHabits = exampleHabits[name];
    const { numbers } = hand;
    // The turns of a zigzag are part of its strokes.
    expect(Math.abs(numbers.length / length - 1)).toBeLessThan(isZigzag ? 0.3 : 0.2);
    // Strokes that run dry narrow towards their end in skips, and those with hooks bend there.
    if (!skips) expect(Math.abs(numbers.taperEnd - taperEnd)).toBeLessThan(0.15);
    if (!hooks) expect(Math.abs(numbers.curvature - curvature)).toBeLessThan(0.035);
    expect(numbers.crossingFrom < 1).toBe(crossing !== undefined);
    if (!crossing) return;
    const turn = Math.abs(numbers.crossingAngle - crossing.angle) % 180;
    expect(Math.min(turn, 180 - turn)).toBeLessThan(4);
  });
});

test('strokes of a felt tip are straight, even and blunt, unlike a scribble', () => {
  const numbers = (name: 'feltTip' | 'scribble'): HandNumbers => exampleHand(name).numbers;
  const [felt, scribble] = [numbers('feltTip'), numbers('scribble')];
  for (const number of ['wobble', 'angleSpread', 'spacingSpread', 'lengthSpread'] as const) {
    expect(felt[number], number).toBeLessThan(0.5 * scribble[number]);
  }
  expect([felt.taperStart, felt.taperEnd]).toEqual([0, 0]);
});

test('a wrong name or seed throws an error with the remedy', () => {
  expect(() => exampleHand('chalk' as never)).toThrow(
    /^exampleHand: there is no hand "chalk"; use one of brush, dryBrush, .*\.$/,
  );
  expect(() => exampleHand('toString' as never)).toThrow(/there is no hand "toString"/);
  expect(() => exampleHand('brush', { seed: 0.5 })).toThrow(/seed is 0.5, but must be a whole number/);
});

/** The width at a share of the way along a stroke, by the nearest of its points. */
const widthAt = ({ widths }: HandStroke, share: number): number => widths[Math.round(share * (widths.length - 1))];

const meanAt = (name: ExampleHandName, share: number): number => {
  const { strokes } = exampleHand(name);
  return strokes.reduce((sum, stroke) => sum + widthAt(stroke, share), 0) / strokes.length;
};

describe('what a tool does', () => {
  test('a felt tip leaves a spot at both ends', () => {
    for (const share of [0, 1]) expect(meanAt('feltTip', share)).toBeGreaterThan(1.25 * meanAt('feltTip', 0.5));
  });

  test('a woodcut tool leaves a wedge, a steel pen opens and closes', () => {
    const wedge = [0, 0.5, 1].map((share) => meanAt('woodcut', share));
    expect(wedge[1] / wedge[0]).toBeCloseTo(0.56, 1);
    expect(wedge[2]).toBeLessThan(0.1 * wedge[0]);
    for (const share of [0, 1]) expect(meanAt('finePen', share)).toBeLessThan(0.3 * meanAt('finePen', 0.5));
  });

  test('a dry brush skips hardly at its start, and half of its way at its end; a crayon all along', () => {
    const skipped = (name: ExampleHandName, from: number, to: number): number => {
      const widths = exampleHand(name).strokes.flatMap(({ widths }) =>
        widths.slice(Math.ceil(from * widths.length), Math.floor(to * widths.length)),
      );
      return widths.filter((width) => width <= 0.01).length / widths.length;
    };
    expect(skipped('dryBrush', 0, 0.25)).toBeLessThan(0.01);
    expect(skipped('dryBrush', 0.8, 1)).toBeGreaterThan(0.4);
    for (const from of [0, 0.4, 0.8]) expect(skipped('crayon', from, from + 0.2)).toBeGreaterThan(0.15);
    expect(skipped('brush', 0, 1)).toBe(0);
  });

  test('a quill hooks off at its start and a ballpoint at its end', () => {
    /** The mean angle between the ends' direction and the chord's, in degrees. */
    const turned = (name: ExampleHandName, atStart: boolean): number => {
      const { strokes } = exampleHand(name);
      const angles = strokes.map(({ points }) => {
        const last = points.length - 2;
        const from = atStart ? 0 : last - 2;
        const end = Math.atan2(points[from + 3] - points[from + 1], points[from + 2] - points[from]);
        const chord = Math.atan2(points[last + 1] - points[1], points[last] - points[0]);
        return Math.abs(Math.atan2(Math.sin(end - chord), Math.cos(end - chord)));
      });
      return (angles.reduce((sum, angle) => sum + angle, 0) / angles.length / Math.PI) * 180;
    };
    expect(turned('quill', true)).toBeGreaterThan(2 * turned('quill', false));
    expect(turned('ballpoint', false)).toBeGreaterThan(2 * turned('ballpoint', true));
  });
});
