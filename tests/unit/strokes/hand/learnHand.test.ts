import { describe, expect, it } from 'vitest';
import type { HandNumbers, HandStroke } from '../../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { drawSwatch, type SwatchDrawing } from './drawSwatch.js';

/** Expects a learnt number within 10 % of what was drawn. */
function expectLearnt(numbers: HandNumbers, expected: Partial<HandNumbers>): void {
  for (const [name, value] of Object.entries(expected)) {
    const learnt = numbers[name as keyof HandNumbers];
    expect(Math.abs(learnt - value), `${name}: ${learnt} for ${value}`).toBeLessThanOrEqual(0.1 * Math.abs(value));
  }
}

const learnt = (...drawings: Partial<SwatchDrawing>[]): HandNumbers => learnHand(drawings.flatMap(drawSwatch)).numbers;

describe('learnHand', () => {
  it.each<Partial<SwatchDrawing>>([
    { length: 8, angle: 0, width: 0.3, spacing: 0.9 },
    { length: 20, angle: 37, width: 0.8, spacing: 2, wobble: 0.15 },
    { length: 3, angle: -80, width: 0.5, spacing: 1.1, taperEnd: 0.6 },
    { length: 12, angle: 90, width: 0.4, spacing: 1, taperStart: 0.2, taperEnd: 0.35, curvature: 0.08 },
    { length: 15, angle: 135, width: 0.6, spacing: 1.5, taperStart: 0.1, taperEnd: 0.1, curvature: -0.2 },
    { length: 12, angle: 179, width: 0.2, spacing: 0.8, rows: 5 },
  ])('learns the strokes of $length mm at $angle degrees', (drawing) => {
    const { angle, rows, ...expected } = drawing;
    expectLearnt(learnt({ ...drawing, seed: 3 }), expected);
  });

  it('learns spreads from many random strokes', () => {
    const numbers = learnt({ rows: 600, lengthSpread: 0.2, angleSpread: 4, widthSpread: 0.25, spacingSpread: 0.2 });
    expectLearnt(numbers, { lengthSpread: 0.2, angleSpread: 4, widthSpread: 0.25, spacingSpread: 0.2, spacing: 1.2 });
  });

  it('distinguishes ruled strokes from random ones', () => {
    expect(learnt({}).spacingSpread).toBeLessThan(0.02);
    expect(learnt({}).clustering).toBeLessThan(0.02);
    const chance = learnt({ rows: 400, spacingSpread: 0.6 });
    expect(chance.spacingSpread).toBeGreaterThan(0.45);
  });

  it('learns bundles', () => {
    const numbers = learnt({ rows: 60, bundle: 5, bundleGap: 4 });
    // Four distances of 1.2 mm and one of 4.8 mm.
    const mean = (4 * 1.2 + 4.8) / 5;
    expectLearnt(numbers, { spacing: mean, clustering: 1 - 1.2 / mean });
  });

  it.each([0.15, -0.2, 0.3])('learns rows of strokes that overlap by %s', (overlap) => {
    const numbers = learnt({ rows: 20, columns: 6, overlap, spacingSpread: 0.1 });
    expectLearnt(numbers, { overlap, spacing: 1.2, length: 12 });
  });

  it.each([60, 90, -45])('learns a second layer at %s degrees', (angle) => {
    const first = drawSwatch({ angle: 20, angleSpread: 2 });
    const over = drawSwatch({ angle: 20 + angle, angleSpread: 2, seed: 2, rows: 16 });
    const second = movedOnto(over, first);
    const numbers = learnHand([
      ...first,
      ...second.map((stroke) => ({ ...stroke, swatch: 'middle' as const })),
    ]).numbers;
    expectLearnt(numbers, { crossingAngle: angle, crossingFrom: 0.375, spacing: 1.2 });
    expect(numbers.angleSpread).toBeLessThan(3);
    const dark = learnHand([
      ...first.map((stroke) => ({ ...stroke, swatch: 'light' as const })),
      ...drawSwatch({ angle: 20, swatch: 'dark' }),
      ...second.map((stroke) => ({ ...stroke, swatch: 'dark' as const })),
    ]).numbers;
    expectLearnt(dark, { crossingFrom: 0.625 });
  });

  it('finds no second layer where nothing crosses: one swatch turned, or a wide spread', () => {
    const turned = learnHand([
      ...drawSwatch({ swatch: 'light' }),
      ...drawSwatch({ angle: 70, swatch: 'dark', seed: 4 }),
    ]);
    expect(turned.numbers).toMatchObject({ crossingAngle: 0, crossingFrom: 1 });
    expect(turned.numbers.angleSpread).toBeLessThan(1);
    for (let seed = 1; seed <= 10; seed++) {
      expect(learnt({ angleSpread: 14, rows: 40, seed }).crossingAngle).toBe(0);
    }
  });

  it('takes the spacing of the middle swatch', () => {
    const spacings = { light: 3, middle: 1.5, dark: 0.8 };
    const numbers = learnt(
      ...(['dark', 'light', 'middle'] as const).map((swatch) => ({ swatch, spacing: spacings[swatch], rows: 7 })),
    );
    expectLearnt(numbers, { spacing: 1.5 });
  });

  it('keeps strokes from all over the swatch', () => {
    const { strokes } = learnHand(drawSwatch({ rows: 300 }), { maxStrokes: 10 });
    const heights = strokes.map(({ points }) => points[1]);
    const [lowest, highest] = [Math.min(...heights), Math.max(...heights)];
    const all = drawSwatch({ rows: 300 }).map(({ points }) => points[1]);
    expect((highest - lowest) / (Math.max(...all) - Math.min(...all))).toBeGreaterThan(0.8);
  });

  it('splits a scribble at its turns', () => {
    const legs = 20;
    const points = Array.from({ length: legs * 40 + 1 }, (_, i) => {
      const leg = Math.floor(i / 40);
      const share = (i % 40) / 40;
      return [10 * (leg % 2 ? 1 - share : share), i * 0.02];
    }).flat();
    const { numbers, strokes } = learnHand([{ points, widths: points.filter((_, i) => i % 2).map(() => 0.3) }]);
    expect(strokes).toHaveLength(legs);
    expectLearnt(numbers, { length: 10, width: 0.3, spacing: 0.8 });
  });

  it('does not depend on the direction or order of strokes', () => {
    const strokes = drawSwatch({ angle: 30, curvature: 0.1, taperStart: 0.3, taperEnd: 0.3 });
    const shuffled = strokes.map((stroke, i) => (i % 3 === 1 ? reversed(stroke) : stroke)).reverse();
    const [a, b] = [learnHand(strokes).numbers, learnHand(shuffled).numbers];
    expectLearnt(a, { curvature: 0.1 });
    for (const name of Object.keys(a) as (keyof HandNumbers)[]) expect(b[name], name).toBeCloseTo(a[name], 5);
  });

  it('keeps the strokes, resampled, as plain data', () => {
    const hand = learnHand(drawSwatch({ rows: 300 }), { name: 'mine', maxStrokes: 50, maxPoints: 16 });
    expect(hand.name).toBe('mine');
    expect(hand.strokes).toHaveLength(50);
    for (const { points, widths } of hand.strokes) {
      expect(widths).toHaveLength(16);
      expect(points).toHaveLength(32);
    }
    expect(JSON.parse(JSON.stringify(hand))).toEqual(hand);
    expect(learnHand(hand.strokes).numbers.length).toBeCloseTo(hand.numbers.length, 2);
  });

  it('learns from a single stroke', () => {
    const { numbers } = learnHand(drawSwatch({ rows: 1, curvature: 0.05 }));
    expectLearnt(numbers, { length: 12, curvature: 0.05, width: 0.4, spacing: 1.2 });
    for (const value of Object.values(numbers)) expect(value).toSatisfy(Number.isFinite);
  });

  it('accepts 100,000 points, however divided into strokes', { tags: ['all'] }, () => {
    for (const perStroke of [2, 100, 50_000]) {
      const strokes = Array.from({ length: 100_000 / perStroke }, (_, row) => ({
        points: Array.from({ length: perStroke }, (_, i) => [(10 * i) / (perStroke - 1), 0.01 * row]).flat(),
        widths: new Array(perStroke).fill(0.2),
      }));
      const { numbers } = learnHand(strokes);
      expectLearnt(numbers, { length: 10 });
      expect(numbers.spacing).toBeGreaterThan(0);
    }
  });
});

describe('errors for bad strokes', () => {
  const line: HandStroke = { points: [0, 0, 5, 0], widths: [0.3, 0.3] };
  it.each<[string, unknown, string]>([
    ['none', [], 'learnHand: there are no strokes; draw at least one.'],
    ['no array', 'strokes', 'learnHand: the strokes are strokes, but must be an array of { points, widths }.'],
    ['null', [null], 'learnHand: strokes[0] is null, but must be { points, widths }.'],
    ['no points', [{ widths: [1] }], 'learnHand: strokes[0].points is undefined, but must be an array of numbers.'],
    ['no widths', [{ points: [0, 1] }], 'learnHand: strokes[0].widths is undefined, but must be an array of numbers.'],
    [
      'one point',
      [{ points: [0, 1], widths: [1] }],
      'learnHand: strokes[0] has 1 points, but a stroke needs two or more.',
    ],
    [
      'lengths that differ',
      [line, { ...line, widths: [1, 1, 1] }],
      'learnHand: strokes[1] has 4 coordinates and 3 widths, but needs x, y and a width for every point.',
    ],
    [
      'NaN',
      [{ ...line, points: [0, 0, Number.NaN, 0] }],
      'learnHand: strokes[0].points[2] is NaN, but must be a number from −10000 to 10000 mm.',
    ],
    [
      'infinity',
      [{ ...line, points: [0, Number.POSITIVE_INFINITY, 1, 0] }],
      'learnHand: strokes[0].points[1] is Infinity, but must be a number from −10000 to 10000 mm.',
    ],
    [
      'no width',
      [{ ...line, widths: [0.3, 0] }],
      'learnHand: strokes[0].widths[1] is 0, but must be a width above 0 mm and up to 10000 mm.',
    ],
    [
      'an unknown swatch',
      [{ ...line, swatch: 'black' }],
      'learnHand: strokes[0].swatch is black, but must be one of light, middle, dark, or left out.',
    ],
    [
      'dots',
      [
        { points: [0, 0, 0, 0], widths: [1, 1] },
        { points: [3, 3, 3.2, 3, 3, 3.1], widths: [1, 1, 1] },
      ],
      'learnHand: all strokes are dots; draw strokes longer than wide.',
    ],
    [
      'too many points',
      Array.from({ length: 50_001 }, () => line),
      'learnHand: the strokes have more than 100000 points; give fewer strokes or points.',
    ],
  ])('%s', (_, strokes, sentence) => {
    expect(() => learnHand(strokes as HandStroke[])).toThrow(sentence);
  });

  it('options out of range', () => {
    expect(() => learnHand([line], { maxPoints: 3 })).toThrow(
      'maxPoints is 3, but must be a whole number from 4 to 64',
    );
    expect(() => learnHand([line], { maxStrokes: 0 })).toThrow('maxStrokes is 0');
    expect(() => learnHand([line], { name: 3 as unknown as string })).toThrow('name is 3, but must be a text');
  });
});

function reversed({ points, widths, swatch }: HandStroke): HandStroke {
  const pairs = Array.from(widths, (_, i) => [points[2 * i], points[2 * i + 1]]).reverse();
  return { points: pairs.flat(), widths: widths.toReversed(), swatch };
}

/** The strokes, moved so that their middle lies on that of others. */
function movedOnto(strokes: HandStroke[], others: HandStroke[]): HandStroke[] {
  const centre = (all: HandStroke[], axis: number): number => {
    const values = all.flatMap(({ points }) => points.filter((_, i) => i % 2 === axis));
    return values.reduce((a, b) => a + b) / values.length;
  };
  const by = [0, 1].map((axis) => centre(others, axis) - centre(strokes, axis));
  return strokes.map((stroke) => ({ ...stroke, points: stroke.points.map((value, i) => value + by[i % 2]) }));
}
