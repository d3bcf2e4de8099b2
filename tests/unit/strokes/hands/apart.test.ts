import { expect, test } from 'vitest';
import { HAND_NUMBER_NAMES, type HandNumbers } from '../../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { type ExampleHandName, exampleHand, exampleHandNames } from '../../../../src/strokes/hands/exampleHand.js';
import { meanInk } from '../../../../src/strokes/tamImages/checkHatchImages.js';
import { generateHatchImages } from '../../../../src/strokes/tamImages/generateHatchImages.js';
import { finish, requestOf } from '../draw.js';
import { trace } from '../strokeTracing/trace.js';

/** Pixels per side and tone of the pictures that are compared. */
const SIDE = 200;
const TONE = 0.2;
/** Scanned pixels per pixel of the drawing and side. */
const SCAN = 3;

/** The map's hatch image nearest to the tone, as 200 × 200 pixels. */
function pictureOf(name: ExampleHandName, seed: number): Uint8Array {
  const { images: tones } = finish(
    generateHatchImages(
      requestOf({ hand: exampleHand(name), size: 256, tones: 16, levels: 1, strokeTexels: 2.6, seed }),
    ),
  );
  const images = tones.map(([finest]) => finest);
  const missing = images.map((image) => Math.abs(meanInk(image) - TONE));
  const best = missing.indexOf(Math.min(...missing));
  expect(missing[best]).toBeLessThan(0.035);
  return Uint8Array.from({ length: SIDE * SIDE }, (_, i) => images[best][Math.floor(i / SIDE) * 256 + (i % SIDE)]);
}

/** The picture enlarged bilinearly, as by a scanner. */
function scanned(picture: Uint8Array) {
  const width = SCAN * SIDE;
  const at = (x: number, y: number): number =>
    picture[Math.min(SIDE - 1, Math.max(0, y)) * SIDE + Math.min(SIDE - 1, Math.max(0, x))];
  const data = Uint8Array.from({ length: width * width }, (_, i) => {
    const [x, y] = [((i % width) + 0.5) / SCAN - 0.5, (Math.floor(i / width) + 0.5) / SCAN - 0.5];
    const [left, top] = [Math.floor(x), Math.floor(y)];
    const upper = at(left, top) + (x - left) * (at(left + 1, top) - at(left, top));
    const lower = at(left, top + 1) + (x - left) * (at(left + 1, top + 1) - at(left, top + 1));
    return upper + (y - top) * (lower - upper);
  });
  return { width, height: width, data };
}

const measured = (name: ExampleHandName, seed: number): HandNumbers =>
  learnHand(trace(scanned(pictureOf(name, seed)), { millimetresPerPixel: 1 / SCAN })).numbers;

/** Least visible difference of each number, in pixels, degrees and shares. */
const LEAST: HandNumbers = {
  length: 3,
  lengthSpread: 0.05,
  curvature: 0.01,
  taperStart: 0.05,
  taperEnd: 0.05,
  width: 0.2,
  widthSpread: 0.05,
  wobble: 0.1,
  angleSpread: 1,
  spacing: 1,
  spacingSpread: 0.05,
  clustering: 0.08,
  overlap: 0.08,
  crossingAngle: 5,
  crossingFrom: 0.1,
};

/**
 * The numbers by which two hands differ: by a quarter of the larger one at least, whichever of the maps of each is measured, so that what
 * chance does from map to map is no difference.
 */
function differences(
  one: readonly HandNumbers[],
  other: readonly HandNumbers[],
  least: HandNumbers,
): (keyof HandNumbers)[] {
  return HAND_NUMBER_NAMES.filter((name) =>
    one.every((a) =>
      other.every((b) => {
        const difference = Math.abs(a[name] - b[name]);
        return difference >= Math.max(least[name], 0.25 * Math.max(Math.abs(a[name]), Math.abs(b[name])));
      }),
    ),
  );
}

/** The hands that a map of 200 pixels tells apart; strokes with grain need more. */
const ON_MAPS = ['brush', 'reedPen', 'finePen', 'scribble'] as const satisfies readonly ExampleHandName[];

test('at 200 px and equal tone, every pair of hands differs by a quarter in at least two measured numbers', {
  tags: ['all'],
}, () => {
  const hands = ON_MAPS.map((name) => ({ name, numbers: [measured(name, 1), measured(name, 2)] }));
  expect(alikeOf(hands, LEAST)).toEqual([]);
  // Two maps of one hand do not differ by this measure.
  const again = [measured('finePen', 3), measured('finePen', 4)];
  expect(differences(again, hands[ON_MAPS.indexOf('finePen')].numbers, LEAST).length).toBeLessThan(2);
});

test('on their sheets, every pair of the twelve hands differs by a quarter in at least four numbers, whatever the seed', () => {
  const least = { ...LEAST, length: 0.5, width: 0.05, wobble: 0.02, spacing: 0.15 };
  const drawn = (name: ExampleHandName, seed: number) => exampleHand(name, { seed }).numbers;
  const hands = exampleHandNames.map((name) => ({ name, numbers: [drawn(name, 1), drawn(name, 2)] }));
  expect(hands).toHaveLength(12);
  expect(alikeOf(hands, least, 4)).toEqual([]);
  for (const { name, numbers } of hands) {
    expect(differences([drawn(name, 3), drawn(name, 4)], numbers, least).length, name).toBeLessThan(3);
  }
});

/** The pairs of hands that differ in fewer numbers than they should. */
function alikeOf(
  hands: readonly { name: ExampleHandName; numbers: readonly HandNumbers[] }[],
  least: HandNumbers,
  differing = 2,
) {
  return hands
    .flatMap(({ name, numbers }, i) =>
      hands
        .slice(i + 1)
        .map((other) => ({ pair: `${name}, ${other.name}`, by: differences(numbers, other.numbers, least) })),
    )
    .filter(({ by }) => by.length < differing);
}
