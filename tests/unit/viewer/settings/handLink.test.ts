import { expect, test } from 'vitest';
import type { Hand, HandStroke } from '../../../../src/strokes/hand/Hand.js';
import { LONGEST_HAND_LINK, readHand, writeHand } from '../../../../src/viewer/settings/handLink.js';
import { Random } from '../../../../src/viewer/settings/Random.js';

const NUMBERS: Hand['numbers'] = {
  ...{ length: 12.345, lengthSpread: 0.2, curvature: -0.031, taperStart: 0.1, taperEnd: 0.25, width: 0.4 },
  ...{ widthSpread: 0.3, wobble: 0.08, angleSpread: 4.5, spacing: 1.2, spacingSpread: 0.4, clustering: 0.1 },
  ...{ overlap: -0.2, crossingAngle: -60, crossingFrom: 0.625 },
};

/** An arc with a swelling width, of 24 points. */
function arc(random: Random): HandStroke {
  const [x, y, length, bow] = [60 * random.next(), 70 * random.next(), 6 + 10 * random.next(), random.next() - 0.5];
  const shares = Array.from({ length: 24 }, (_, i) => i / 23);
  return {
    points: shares.flatMap((share) => [x + length * share, y + 4 * bow * share * (1 - share)]),
    widths: shares.map((share) => 0.1 + 1.2 * share * (1 - share)),
    swatch: random.pick(['light', 'middle', 'dark'] as const),
  };
}

const handOf = (count: number, seed = 1): Hand => {
  const random = new Random(seed);
  return { version: 1, strokes: Array.from({ length: count }, () => arc(random)), numbers: NUMBERS };
};

/** How far a point of a stroke, and its width there, is from a polyline. */
function distanceTo({ points, widths }: HandStroke, x: number, y: number, width: number): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 1 < widths.length; i++) {
    for (let share = 0; share <= 1; share += 0.02) {
      const px = points[2 * i] + share * (points[2 * i + 2] - points[2 * i]);
      const py = points[2 * i + 1] + share * (points[2 * i + 3] - points[2 * i + 1]);
      const w = widths[i] + share * (widths[i + 1] - widths[i]);
      nearest = Math.min(nearest, Math.max(Math.hypot(px - x, py - y), Math.abs(w - width)));
    }
  }
  return nearest;
}

test('a hand comes back from its text: numbers to a thousandth, strokes and widths within a tenth of a millimetre', () => {
  const hand = handOf(20);
  const text = writeHand(hand)!;
  expect(text).toMatch(/^[\w-]+$/);
  const read = readHand(text)!;
  expect(read.numbers).toEqual(NUMBERS);
  expect(read.strokes.map(({ swatch }) => swatch)).toEqual(hand.strokes.map(({ swatch }) => swatch));
  hand.strokes.forEach(({ points, widths }, i) => {
    for (let k = 0; k < widths.length; k++) {
      expect(distanceTo(read.strokes[i], points[2 * k], points[2 * k + 1], widths[k])).toBeLessThan(0.1);
    }
  });
});

test('twenty strokes fit into a link, and hundreds do not', () => {
  expect(writeHand(handOf(20))!.length).toBeLessThan(LONGEST_HAND_LINK / 2);
  expect(writeHand(handOf(60))!.length).toBeLessThanOrEqual(LONGEST_HAND_LINK);
  expect(writeHand(handOf(400))).toBeUndefined();
});

test('a thin stroke stays visible', () => {
  const hand = { ...handOf(1), strokes: [{ points: [1, 2, 8, 9], widths: [0.001, 0.3] }] };
  expect(readHand(writeHand(hand)!)!.strokes).toEqual([
    { points: [1, 2, 8, 9], widths: [0.02, 0.3], swatch: 'middle' },
  ]);
});

test('damaged texts are rejected: every truncation, 2,000 changed letters, other versions, and empty text', () => {
  const text = writeHand(handOf(8))!;
  for (let length = 0; length < text.length; length++) expect(readHand(text.slice(0, length))).toBeUndefined();
  const random = new Random(5);
  for (let i = 0; i < 2000; i++) {
    const at = Math.floor(random.next() * text.length);
    const letter = random.pick([...'AZaz09-_']);
    const read = readHand(text.slice(0, at) + letter + text.slice(at + 1));
    for (const { points, widths } of read?.strokes ?? []) {
      expect(points.length).toBe(2 * widths.length);
      expect([...points, ...widths].every(Number.isFinite) && widths.every((width) => width > 0)).toBe(true);
    }
  }
  for (const wrong of ['', 'B', '____', `${text}é`, 'A'.repeat(LONGEST_HAND_LINK + 1), `C${text.slice(1)}`]) {
    expect(readHand(wrong)).toBeUndefined();
  }
});
