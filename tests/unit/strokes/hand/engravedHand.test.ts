import { describe, expect, it } from 'vitest';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import {
  HAND_NUMBER_NAMES,
  HAND_NUMBER_RANGES,
  type Hand,
  type HandNumbers,
  handLines,
} from '../../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { random } from '../../../../src/strokes/random.js';
import { drawSwatch } from './drawSwatch.js';

const { numbers } = learnHand(drawSwatch({ taperStart: 0.2, taperEnd: 0.3, widthSpread: 0.1, wobble: 0.05 }));
const of = (changed: Partial<HandNumbers>) => handLines({ numbers: { ...numbers, ...changed } });

describe('handLines', () => {
  it.each<[keyof HandNumbers, readonly number[], (hand: ReturnType<typeof of>) => number]>([
    ['widthSpread', [0, 0.1, 0.2, 0.3], ({ material }) => material.irregularity],
    ['wobble', [0, 0.05, 0.1, 0.2], ({ material }) => material.irregularity],
    ['spacingSpread', [0, 0.2, 0.4, 0.8], ({ material }) => material.irregularity],
    ['length', [5, 10, 20, 40], ({ material }) => material.strokeLength],
    ['taperStart', [0, 0.2, 0.5, 1], ({ outlines }) => outlines.taper],
    ['taperEnd', [0, 0.2, 0.5, 1], ({ outlines }) => outlines.taper],
    ['widthSpread', [0, 0.1, 0.2, 0.5], ({ outlines }) => outlines.accents],
    ['wobble', [0, 0.05, 0.1, 0.2], ({ outlines }) => outlines.wobble],
  ])('grows with %s', (name, values, read) => {
    const results = values.map((value) => read(of({ [name]: value })));
    for (let i = 1; i < results.length; i++) expect(results[i]).toBeGreaterThan(results[i - 1]);
  });

  it('is ruled and without tapers for a ruled hand', () => {
    const ruled = of({ widthSpread: 0, wobble: 0, spacingSpread: 0, taperStart: 0, taperEnd: 0 });
    expect(ruled.material.irregularity).toBe(0);
    expect(ruled.outlines).toEqual({ taper: 0, accents: 0, wobble: 0 });
  });

  it('crosses as the hand does', () => {
    expect(of({ crossingAngle: 0, crossingFrom: 1 }).material).toMatchObject({ crossFrom: 1 });
    const { crossFrom, crossAngle } = of({ crossingAngle: -45, crossingFrom: 0.3 }).material;
    expect(crossFrom).toBe(0.3);
    expect(crossAngle).toBeCloseTo(Math.PI / 4);
  });

  it('scales with lines and outlines', () => {
    const [one, two] = [1, 2].map((factor) =>
      handLines({ numbers }, { lineSpacing: 4 * factor, outlineWidth: 2 * factor }),
    );
    expect(two.material.strokeLength).toBeCloseTo(2 * one.material.strokeLength);
    expect(two.outlines.wobble).toBeCloseTo(2 * one.outlines.wobble);
    expect(two.material.irregularity).toBe(one.material.irregularity);
  });

  it('gives values that materials and outlines accept, whatever the numbers', () => {
    const next = random(3);
    for (let i = 0; i < 60; i++) {
      const any = Object.fromEntries(
        HAND_NUMBER_NAMES.map((name) => {
          const { from, to } = HAND_NUMBER_RANGES[name];
          return [name, from + (to - from) * [0, 1, next() ** 3][Math.floor(3 * next())]];
        }),
      ) as unknown as HandNumbers;
      const { material, outlines } = handLines({ numbers: any });
      expect(() => new HatchingMaterial({ technique: 'engraving', ...material }).dispose()).not.toThrow();
      expect(() => new HatchingOutlineMaterial(outlines).dispose()).not.toThrow();
      expect(material.irregularity).toBeLessThanOrEqual(1);
    }
  });

  it.each([
    [null, 'handLines: hand is null, but must be { version, strokes, numbers }; learnHand makes one from strokes.'],
    [[], 'handLines: hand is an array, but must be { version, strokes, numbers }; learnHand makes one from strokes.'],
    [{ version: 99 }, 'handLines: hand.numbers is undefined, but must be an object with the learnt numbers.'],
    [{ numbers: {} }, /^handLines: hand\.numbers\.\w+ is undefined, but must be a number from /],
  ])('says what is wrong with %j', (hand, message) => {
    expect(() => handLines(hand as unknown as Hand)).toThrow(message);
  });
});
