import { describe, expect, test } from 'vitest';
import type { Hand, HandNumbers, HandStroke } from '../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { HAND_TEXTURE, MOST_REACH } from '../../../src/strokes/handConstants.js';
import { MOST_PROFILES, type StrokeProfiles, strokeProfiles } from '../../../src/strokes/strokeProfiles.js';

const { PLACES } = HAND_TEXTURE;

/** Straight strokes of 10 mm, from 0.2 mm wide at the start to 0.8 mm, at an angle. */
const stroke = (
  y: number,
  { width = 1, angle = 0.4, swatch }: { width?: number; angle?: number; swatch?: HandStroke['swatch'] } = {},
): HandStroke => ({
  points: [0, 0.25, 0.5, 0.75, 1].flatMap((share) => [10 * share * Math.cos(angle), y + 10 * share * Math.sin(angle)]),
  widths: [0.2, 0.5, 0.8, 0.8, 0.8].map((value) => width * value),
  swatch,
});
const rows = (count: number, of: Parameters<typeof stroke>[1] = {}): HandStroke[] =>
  Array.from({ length: count }, (_, i) => stroke(2 * i, of));

const changed = (hand: Hand, numbers: Partial<HandNumbers>): Hand => ({
  ...hand,
  numbers: { ...hand.numbers, ...numbers },
});
const still = { angleSpread: 0, spacingSpread: 0 };

/** Offsets and half widths of a stroke, in millimetres. */
const profile = ({ strokes, spacing }: StrokeProfiles, row: number): { offset: number[]; half: number[] } => {
  const texels = Array.from(strokes.subarray(2 * PLACES * row, 2 * PLACES * (row + 1)), (value) => value * spacing);
  return { offset: texels.filter((_, i) => i % 2 === 0), half: texels.filter((_, i) => i % 2 === 1) };
};
const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
const deviation = (values: readonly number[]): number =>
  Math.sqrt(mean(values.map((value) => (value - mean(values)) ** 2)));

test('strokes lie straight along their rows, whatever the angle at which they were drawn', () => {
  const profiles = strokeProfiles(changed(learnHand(rows(8, { angle: 1 })), still));
  for (let row = 0; row < profiles.count; row++)
    expect(Math.max(...profile(profiles, row).offset.map(Math.abs))).toBeLessThan(0.05);
});

test('strokes run the way in which most were drawn', () => {
  const turned = ({ points, widths }: HandStroke): HandStroke => ({
    points: points.flatMap((_, i) =>
      i % 2 === 0 ? [points[points.length - 2 - i], points[points.length - 1 - i]] : [],
    ),
    widths,
  });
  const hand = learnHand([...rows(6), ...rows(3).map(turned)]);
  const profiles = strokeProfiles(changed(hand, still));
  const starts = Array.from({ length: profiles.count }, (_, row) => {
    const { half } = profile(profiles, row);
    return half[2] < half[PLACES - 3];
  });
  // Strokes that were drawn back taper at the other end.
  expect(starts.filter(Boolean).length / starts.length).toBeCloseTo(2 / 3, 1);
});

describe('the numbers of a hand hold', () => {
  const hand = changed(learnHand(rows(12)), still);

  test.each([0.2, 0.8, 2])('width: %d mm', (width) => {
    const profiles = strokeProfiles(changed(hand, { width }));
    const full = Array.from(
      { length: profiles.count },
      (_, row) => 2 * profile(profiles, row).half[Math.round(0.8 * PLACES)],
    );
    expect(Math.abs(mean(full) / width - 1)).toBeLessThan(0.15);
  });

  test.each([4, 20])('length: %d mm', (length) => {
    const { cell, filled, shorter } = strokeProfiles(changed(hand, { length, lengthSpread: 0.4 }));
    expect(cell * filled * (1 - 0.5 * shorter)).toBeCloseTo(length, 5);
    expect(shorter).toBeGreaterThan(0.4);
  });

  test.each([3, 8])('angleSpread: %d°', (angleSpread) => {
    const profiles = strokeProfiles(changed(hand, { angleSpread, spacing: 6 }));
    const angles = Array.from({ length: profiles.count }, (_, row) => {
      const { offset } = profile(profiles, row);
      return (Math.atan((offset[PLACES - 1] - offset[0]) / hand.numbers.length) * 180) / Math.PI;
    });
    expect(Math.abs(deviation(angles) / angleSpread - 1)).toBeLessThan(0.15);
  });

  test('overlap: a gap between the strokes of a row', () => {
    expect(strokeProfiles(changed(hand, { overlap: -0.5 })).filled).toBeCloseTo(1 / 1.5, 5);
  });

  test('overlap: rows of two lanes, whose strokes are as long as others', () => {
    const { cell, filled, shorter, laneOffset, laneShift } = strokeProfiles(changed(hand, { overlap: 0.3 }));
    expect(cell * filled * (1 - 0.5 * shorter)).toBeCloseTo(hand.numbers.length, 5);
    expect(filled).toBeGreaterThan(0.5 / 0.7);
    expect(laneOffset).toBeGreaterThan(0);
    expect(laneShift).toBeCloseTo(2 / 3, 5);
    const together = strokeProfiles(changed(hand, { overlap: 1 }));
    expect(together.filled).toBeGreaterThan(0.9);
    expect(together.laneShift).toBe(0);
    for (const overlap of [-2, 0, 0.03]) expect(strokeProfiles(changed(hand, { overlap })).laneOffset).toBe(0);
  });

  test('clustering: what uneven distances alone do not have is that of bundles', () => {
    const bundledAt = (clustering: number, spacingSpread: number): number =>
      strokeProfiles(changed(hand, { clustering, spacingSpread })).bundled;
    expect(bundledAt(0.3, 0)).toBeCloseTo(0.3, 5);
    expect(bundledAt(0.1, 0.5)).toBe(0);
    expect(bundledAt(1, 0)).toBeLessThan(1);
  });

  test.each([0.1, 0.3])('wobble: %d mm', (wobble) => {
    const profiles = strokeProfiles(changed(hand, { wobble }));
    const strayed = Array.from({ length: profiles.count }, (_, row) => deviation(profile(profiles, row).offset));
    expect(Math.abs(mean(strayed) / wobble - 1)).toBeLessThan(0.15);
  });
});

test('strokes of the light swatch come first, those of the dark one last', () => {
  const swatches = ['dark', 'light', 'middle'] as const;
  const hand = learnHand(swatches.flatMap((swatch, i) => rows(5, { swatch, width: [3, 1, 2][i] })));
  const profiles = strokeProfiles(changed(hand, still));
  const third = profiles.count / 3;
  const widths = [0, 1, 2].map((part) =>
    mean(Array.from({ length: Math.floor(third) }, (_, i) => profile(profiles, Math.floor(part * third) + i).half[50])),
  );
  expect(widths[1] / widths[0]).toBeCloseTo(2, 0);
  expect(widths[2] / widths[0]).toBeCloseTo(3, 0);
});

test('every tone is drawn by more strokes until all are there, and then by wider ones', () => {
  for (const tones of strokeProfiles(learnHand(rows(9))).tones) {
    expect(tones).toHaveLength(PLACES);
    for (const [i, { share, widening }] of tones.entries()) {
      if (i > 0) expect(share + widening).toBeGreaterThanOrEqual(tones[i - 1].share + tones[i - 1].widening);
      expect(widening > 0 && share < 1).toBe(false);
    }
    expect(tones[0]).toEqual({ share: 0, widening: 0 });
    expect(tones[PLACES - 1].share).toBe(1);
  }
});

test.each([
  ['a thousand strokes', learnHand(rows(1000), { maxStrokes: 1000 })],
  ['strokes 100 mm wide', changed(learnHand(rows(5)), { width: 100 })],
  [
    'the widest spreads',
    changed(learnHand(rows(5)), {
      angleSpread: 90,
      spacingSpread: 3,
      lengthSpread: 2,
      widthSpread: 2,
      overlap: -2,
      curvature: 1,
      wobble: 50,
      clustering: 1,
    }),
  ],
  ['strokes beside each other', changed(learnHand(rows(5)), { width: 3, spacing: 2, clustering: 1, overlap: 1 })],
])('%s stay within the texture and near their rows', (_name, hand) => {
  const { count, strokes, offset, halfWidth, bundled, laneOffset, tones } = strokeProfiles(hand);
  expect(count).toBeLessThanOrEqual(MOST_PROFILES);
  expect(strokes).toHaveLength(2 * PLACES * count);
  expect(strokes.every(Number.isFinite)).toBe(true);
  const widest = Math.max(...tones.flat().map(({ widening }) => widening));
  expect(offset + halfWidth + bundled + laneOffset + widest).toBeLessThanOrEqual(MOST_REACH + 1e-6);
});

test('a stroke is found among thousands of dots', () => {
  const dot: HandStroke = { points: [0, 0, 0.1, 0], widths: [1, 1] };
  const hand = learnHand(rows(3));
  const dotted = { ...hand, strokes: [...Array.from({ length: 3000 }, () => dot), stroke(0)] };
  expect(strokeProfiles(dotted).count).toBeGreaterThan(0);
});

test.each([
  ['there are no strokes', { strokes: [] }],
  ['all strokes are dots', { strokes: [{ points: [1, 1, 1, 1], widths: [1, 1] }] }],
  ['points[2] is NaN', { strokes: [{ points: [0, 0, Number.NaN, 1], widths: [1, 1] }] }],
  ['hand.version is 2', { version: 2 }],
  ['hand.numbers.length is 0', { numbers: { ...learnHand(rows(3)).numbers, length: 0 } }],
])('a hand with a fault is named in a sentence: %s', (fault, wrong) => {
  expect(() => strokeProfiles({ ...learnHand(rows(3)), ...wrong } as Hand)).toThrow(fault);
});
