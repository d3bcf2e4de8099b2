import { afterAll, expect, test } from 'vitest';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import type { ScannedImage } from '../../../../src/strokes/strokeTracing/ScannedImage.js';
import type { Random } from '../../../../src/viewer/settings/Random.js';
import { traceStrokes } from '../../../../src/worker/handsAsync.js';
import { photograph, straight } from '../../strokes/strokeTracing/paper.js';
import { NUMBERS, outcome } from './oddThings.js';
import { FUZZ_TIMEOUT, type FuzzReport, runCases, seedsOf, writeReport } from './report.js';

/** Pictures that nobody would take on purpose, of strokes and of anything else. */

const report: FuzzReport = {};

const SIDES = [0, 1, 15, 16, 17, 40, 64, 96, 16.5, Number.NaN, -20, Infinity, '40', undefined];
const NO_PICTURES = [null, undefined, 0, 'picture', [], {}, () => 0, { width: 20, height: 20 }];

/** What the pixels of a picture may show. */
const SCENES: ((random: Random, width: number, height: number) => ArrayLike<number>)[] = [
  (random, width, height) => {
    const strokes = Array.from({ length: random.below(30) }, () =>
      straight(
        (1.2 * random.next() - 0.1) * width,
        (1.2 * random.next() - 0.1) * height,
        random.below(width),
        random.below(360),
        0.5 + random.below(12) * random.next(),
      ),
    );
    return photograph(strokes, {
      width,
      height,
      depth: random.next(),
      blur: random.pick([0, 0, 1, 3]),
      noise: random.pick([0, 5, 40]),
      seed: random.below(1000),
    }).data;
  },
  (random, width, height) => Array.from({ length: width * height }, () => random.below(256)),
  (random, width, height) => {
    const [share, ink] = [random.next(), random.below(256)];
    return Array.from({ length: width * height }, () => (random.chance(share) ? ink : 255));
  },
  (random, width, height) => {
    const [down, across] = [1 + random.below(9), 1 + random.below(9)];
    return Array.from({ length: width * height }, (_, i) =>
      Math.floor((i % width) / across) % 2 === Math.floor(i / width / down) % 2 ? 0 : 255,
    );
  },
  (random, width, height) => {
    const wave = 3 + random.below(30);
    return Array.from({ length: width * height }, (_, i) => 128 + 127 * Math.sin(i / wave) * Math.sin(i / width / 7));
  },
];

function oddPicture(random: Random): ScannedImage {
  if (random.chance(0.05)) return random.pick(NO_PICTURES) as never;
  if (random.chance(0.1)) {
    const [width, height] = [random.pick(SIDES), random.pick(SIDES)];
    return { width, height, data: new Uint8Array(random.pick([0, 400, 1600, 4096])) } as never;
  }
  const [width, height] = [16 + random.below(110), 16 + random.below(110)];
  const grey = random.pick(SCENES)(random, width, height);
  if (random.chance(0.05)) return { width, height, data: Float32Array.from(grey) as never };
  if (random.chance(0.4)) {
    const data = new Uint8ClampedArray(4 * grey.length);
    for (let i = 0; i < grey.length; i++)
      data.set([grey[i], grey[i], random.below(256), random.pick([255, 0, 90])], 4 * i);
    return { width, height, data };
  }
  return { width, height, data: Uint8ClampedArray.from(grey) };
}

async function scanCase(random: Random): Promise<'good' | 'refused'> {
  const image = oddPicture(random);
  const options = random.chance(0.2)
    ? { millimetresPerPixel: random.pick(NUMBERS), swatch: random.pick(['light', 'dark', 'grey', '']) }
    : undefined;
  return outcome(/^(traceStrokes|learnHand): /, async () => {
    const strokes = await traceStrokes(image, options as never);
    for (const { points, widths } of strokes) {
      expect(points).toHaveLength(2 * widths.length);
      expect(points.every(Number.isFinite)).toBe(true);
      expect(widths.every((width) => width > 0 && width < Infinity)).toBe(true);
    }
    const { numbers } = learnHand(strokes);
    for (const [name, value] of Object.entries(numbers)) expect(Number.isFinite(value), name).toBe(true);
  });
}

const seeds = seedsOf(0, 1);
test(`odd pictures give strokes of finite numbers, or a sentence: ${seeds.length} cases`, {
  tags: ['all'],
  timeout: FUZZ_TIMEOUT,
}, async () => {
  const failures = await runCases(report, 'scans', seeds, scanCase);
  expect(failures.slice(0, 20)).toEqual([]);
  // Neither is so strict that nothing is traced, nor so mild that nothing is refused.
  expect(report.scans.good).toBeGreaterThan(0.1 * seeds.length);
  expect(report.scans.refused).toBeGreaterThan(0.1 * seeds.length);
});
afterAll(() => writeReport('scans', report));
