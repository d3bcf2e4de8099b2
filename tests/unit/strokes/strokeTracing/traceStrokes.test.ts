import { describe, expect, test } from 'vitest';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { exampleHand } from '../../../../src/strokes/hands/exampleHand.js';
import { random } from '../../../../src/strokes/random.js';
import type { ScannedImage } from '../../../../src/strokes/strokeTracing/ScannedImage.js';
import { traceStrokesSteps } from '../../../../src/strokes/strokeTracing/traceStrokesSteps.js';
import { gaussian, type InkStroke, type Photograph, photograph, straight } from './paper.js';
import { type Measured, measure, trace } from './trace.js';

/** A lamp to the left, and the edge of the lens. */
const uneven = (x: number, y: number): number => 240 - 110 * x - 40 * ((x - 0.5) ** 2 + (y - 0.5) ** 2);

const CAMERAS: Record<string, Partial<Photograph>> = {
  'as drawn': {},
  'with noise': { noise: 10 },
  'in uneven light': { light: uneven },
  blurred: { blur: 1 },
  'pale ink': { depth: 0.35 },
  'with noise, blurred and in uneven light': { noise: 8, blur: 1, light: uneven },
};

interface Known {
  x: number;
  y: number;
  length: number;
  angle: number;
  width: number;
}

const inkOf = (known: readonly Known[]): InkStroke[] =>
  known.map(({ x, y, length, angle, width }) => straight(x, y, length, angle, width));

/** Expects each known stroke once, and no other, within a tenth in length and width and two degrees in angle. */
function expectStrokes(found: readonly Measured[], known: readonly Known[]): void {
  expect(found).toHaveLength(known.length);
  const left = [...found];
  for (const stroke of known) {
    const turned = (other: Measured): number => Math.abs(((other.angle - stroke.angle + 270) % 180) - 90);
    const at = left.findIndex((other) => Math.hypot(other.x - stroke.x, other.y - stroke.y) < 4 && turned(other) < 2);
    expect(at, JSON.stringify({ stroke, left })).toBeGreaterThanOrEqual(0);
    const [match] = left.splice(at, 1);
    expect(Math.abs(match.length / stroke.length - 1), JSON.stringify({ stroke, match })).toBeLessThan(0.1);
    expect(Math.abs(match.width / stroke.width - 1), JSON.stringify({ stroke, match })).toBeLessThan(0.1);
  }
}

/** Strokes of many widths, lengths and angles, apart from each other. */
const APART: Known[] = [3, 4, 5, 6, 7, 8, 10, 12].map((width, i) => ({
  x: 60 + 90 * (i % 4),
  y: 70 + 130 * Math.floor(i / 4),
  length: 70 + 6 * i,
  angle: 10 + 21 * i,
  width,
}));

/** Pairs that cross at angles from 20 to 90 degrees, and a lattice. */
const CROSSED: Known[] = [
  ...[20, 35, 60, 90].flatMap((turn, i) =>
    [0, turn].map((more) => ({ x: 70 + 120 * i, y: 75, length: 110, angle: 15 + more, width: 5 })),
  ),
  ...[0, 1, 2, 3, 4].flatMap((i) => [
    { x: 240, y: 180 + 22 * i, length: 200, angle: 3, width: 4 },
    { x: 180 + 30 * i, y: 224, length: 140, angle: 70, width: 4 },
  ]),
];

describe('strokes of known count, angle, length and width', () => {
  for (const [name, camera] of Object.entries(CAMERAS)) {
    test(`apart, ${name}`, () => {
      expectStrokes(trace(photograph(inkOf(APART), { width: 400, height: 280, ...camera })).map(measure), APART);
    });
    test(`crossing, ${name}`, () => {
      expectStrokes(trace(photograph(inkOf(CROSSED), { width: 500, height: 310, ...camera })).map(measure), CROSSED);
    });
  }
});

test('a stroke that swells from point to point keeps its points, its bend and its width', () => {
  const arc = Array.from({ length: 41 }, (_, i) => i / 20 - 1);
  const ink: InkStroke = {
    points: arc.map((x) => [150 + 110 * x, 100 - 24 * (1 - x * x)] as const),
    widths: arc.map((x) => 0.6 + 8.4 * (1 - Math.abs(x))),
  };
  const [stroke, ...others] = trace(photograph([ink], { width: 300, height: 160, blur: 0.7, noise: 5 }));
  expect(others).toHaveLength(0);
  const { points, widths } = stroke;
  const last = widths.length - 1;
  expect(Math.abs(points[0] - 40)).toBeLessThan(3);
  expect(Math.abs(points[2 * last] - 260)).toBeLessThan(3);
  for (let i = 0; i <= last; i++) {
    const x = (points[2 * i] - 150) / 110;
    expect(Math.abs(points[2 * i + 1] - (100 - 24 * (1 - x * x)))).toBeLessThan(1);
    const width = 0.6 + 8.4 * (1 - Math.abs(x));
    if (width > 3) expect(Math.abs(widths[i] / width - 1), `${x}`).toBeLessThan(0.1);
    else expect(Math.abs(widths[i] - width), `${x}`).toBeLessThan(0.6);
  }
});

test('strokes with straight ends keep their direction up to the ends', () => {
  for (const angle of [0, 20, 45]) {
    const ink = { ...straight(120, 100, 120, angle, 20), isCut: true };
    const [stroke, ...others] = trace(photograph([ink], { width: 240, height: 200, noise: 8, seed: angle + 1 }));
    expect(others).toHaveLength(0);
    const found = measure(stroke);
    // A round pen of this width would have stood half a width from each end.
    expect(Math.abs(found.length - 100)).toBeLessThan(6);
    expect(Math.abs(found.angle - angle)).toBeLessThan(1);
    const [first, last] = [0, stroke.widths.length - 1].map((i) =>
      Math.hypot(stroke.points[2 * i] - 120, stroke.points[2 * i + 1] - 100),
    );
    expect(Math.abs(first - last)).toBeLessThan(4);
    for (const width of stroke.widths) expect(Math.abs(width / 20 - 1)).toBeLessThan(0.1);
  }
});

test('three strokes through one place go straight on', () => {
  const known = [10, 70, 130].map((angle) => ({ x: 120, y: 100, length: 150, angle, width: 7 }));
  for (const seed of [1, 2, 3]) {
    expectStrokes(trace(photograph(inkOf(known), { width: 240, height: 200, noise: 8, seed })).map(measure), known);
  }
});

test('strokes of one layer all run one way, to the right', () => {
  const known = [30, 36, 42, 48, 54, 60].map((angle, i) => ({
    x: 60 + 50 * i,
    y: 70,
    length: 80,
    angle: -angle,
    width: 4,
  }));
  const strokes = trace(photograph(inkOf(known), { width: 380, height: 140 }));
  expect(strokes).toHaveLength(6);
  for (const { points } of strokes) expect(points[points.length - 2]).toBeGreaterThan(points[0]);
});

const plain = photograph(inkOf(APART), { width: 400, height: 280 });

describe('a hand photographed in light that falls off to a dark corner, under the shadow of an arm', () => {
  const MARGIN = 2.5;
  const SCALE = 30;
  const shadowed = (x: number, y: number): number => {
    const inLight = 1 / (1 + Math.exp(40 * (y - 0.55 - 0.25 * x)));
    return (225 - 90 * x - 50 * ((x - 0.5) ** 2 + (y - 0.5) ** 2)) * (0.66 + 0.34 * inLight);
  };
  for (const name of ['finePen', 'woodcut', 'feltTip'] as const) {
    test(`of a ${name} gives its strokes and no others, and its numbers`, () => {
      const strokes = exampleHand(name, { seed: 9 }).strokes.filter(({ swatch }) => swatch === 'middle');
      const all = strokes.flatMap(({ points }) => points);
      const [xs, ys] = [0, 1].map((axis) => all.filter((_, i) => i % 2 === axis));
      const [left, top] = [Math.min(...xs) - MARGIN, Math.min(...ys) - MARGIN];
      const ink = strokes.map(
        ({ points, widths }): InkStroke => ({
          points: widths.map((_, i) => [SCALE * (points[2 * i] - left), SCALE * (points[2 * i + 1] - top)]),
          widths: widths.map((width) => SCALE * width),
        }),
      );
      const size = (values: number[], from: number): number =>
        Math.round(SCALE * (Math.max(...values) + MARGIN - from));
      const picture = photograph(ink, {
        ...{ width: size(xs, left), height: size(ys, top), light: shadowed, depth: 0.7, blur: 1.3, noise: 9 },
      });
      const traced = trace(picture, { millimetresPerPixel: 1 / SCALE, swatch: 'middle' });
      const { numbers } = learnHand(traced);
      const drawn = learnHand(strokes).numbers;
      // Strokes that touch end to end are one.
      expect(traced.length).toBeLessThanOrEqual(strokes.length);
      expect(traced.length).toBeGreaterThan(0.85 * strokes.length);
      for (const number of ['length', 'width', 'spacing', 'taperEnd', 'angleSpread'] as const)
        expect(Math.abs(numbers[number] - drawn[number]), number).toBeLessThanOrEqual(0.2 * drawn[number]);
    });
  }
});

test('a picture is 60 mm wide by default', () => {
  const [pixels, millimetres] = [trace(plain), trace(plain, { swatch: 'dark' })].map((all) => all.map(measure));
  expect(millimetres.map(({ length }) => length / 60)).toEqual(
    pixels.map(({ length }) => expect.closeTo(length / 400, 4)),
  );
  expect(trace(plain, { swatch: 'dark' }).every(({ swatch }) => swatch === 'dark')).toBe(true);
});

test('RGBA gives the same as grey, with transparent pixels on white', () => {
  const data = new Uint8ClampedArray(4 * plain.data.length);
  plain.data.forEach((grey, i) => {
    data.set(grey > 230 ? [0, 0, 0, 0] : [grey, grey, grey, 255], 4 * i);
  });
  const found = trace({ ...plain, data }).map(measure);
  expectStrokes(found, APART);
});

test('a large picture is reduced, and its strokes keep their size', () => {
  const width = 2400;
  const large: ScannedImage = { width, height: 6 * 280, data: new Uint8Array(width * 6 * 280) };
  for (let i = 0; i < large.data.length; i++) {
    large.data[i] = plain.data[Math.floor(Math.floor(i / width) / 6) * 400 + Math.floor((i % width) / 6)];
  }
  expectStrokes(trace(large, { millimetresPerPixel: 1 / 6 }).map(measure), APART);
});

test('blots, the dark around the sheet and dust are no strokes', () => {
  const blot = straight(412, 140, 150, 90, 46);
  const dust = Array.from({ length: 30 }, (_, i) => straight(10 + 12.5 * i, 8 + (i % 3), 5, 40 * i, 2.5));
  const image = photograph([...inkOf(APART), blot, ...dust], { width: 480, height: 280 });
  for (let y = 0; y < 280; y++) image.data.fill(30, y * 480 + 445, (y + 1) * 480);
  expectStrokes(trace(image).map(measure), APART);
});

test('the same picture gives the same strokes, and stays unchanged', () => {
  const image = photograph(inkOf(CROSSED), { width: 500, height: 310, noise: 8 });
  const before = image.data.slice();
  expect(trace(image)).toEqual(trace(image));
  expect(image.data).toEqual(before);
});

test('progress rises to 1, in many steps', () => {
  const steps = [...traceStrokesSteps({ image: plain })];
  expect(steps.length).toBeGreaterThan(30);
  expect(steps).toEqual(steps.toSorted((a, b) => a - b));
  expect(steps.at(-1)).toBeLessThanOrEqual(1);
});

const flat = (value: (x: number, y: number) => number): ScannedImage => ({
  width: 200,
  height: 160,
  data: Uint8ClampedArray.from({ length: 200 * 160 }, (_, i) => value(i % 200, Math.floor(i / 200))),
});

describe('errors with the fault', () => {
  const next = random(5);
  const cases: [name: string, image: unknown, sentence: RegExp][] = [
    ['white', flat(() => 255), /no strokes were found in the picture: it is the same all over/],
    ['black', flat(() => 0), /no strokes were found.*the same all over/],
    ['noise', flat(() => 190 + 12 * gaussian(next)), /no strokes were found/],
    ['chance', flat(() => 256 * next()), /no strokes were found/],
    ['a ramp of light', flat((x) => 20 + x), /no strokes were found/],
    ['a shadow with a sharp edge', flat((x) => (x < 90 ? 60 : 220)), /no strokes were found/],
    [
      'dots',
      photograph(
        [0, 1, 2, 3].map((i) => straight(30 + 40 * i, 60, 0, 0, 7)),
        { width: 200, height: 120 },
      ),
      /no strokes were found/,
    ],
    ['nothing', undefined, /expected a picture \{ width, height, data \}, but got undefined/],
    ['a narrow one', { width: 200, height: 3, data: new Uint8Array(600) }, /height is 3, but must be .* at least 16/],
    [
      'a huge one',
      { width: 40_000, height: 40_000, data: new Uint8Array(1) },
      /at most 16 million are traced; scale it down/,
    ],
    ['a side that is no number', { width: Number.NaN, height: 30, data: new Uint8Array(1) }, /width is NaN/],
    [
      'too few bytes',
      { width: 20, height: 20, data: new Uint8Array(1200) },
      /1200 bytes, but 20 × 20 pixels need 400 \(grey\) or 1600/,
    ],
    ['numbers that are no bytes', { width: 20, height: 20, data: new Float32Array(400) }, /must be a Uint8Array/],
  ];
  for (const [name, image, sentence] of cases) {
    test(name, () => {
      expect(() => trace(image as ScannedImage)).toThrow(sentence);
      expect(() => trace(image as ScannedImage)).toThrow(/^traceStrokes: [^\n]+\.$/);
    });
  }
  test('options', () => {
    expect(() => trace(plain, { millimetresPerPixel: 0 })).toThrow(
      /millimetresPerPixel is 0, but must be a number above 0/,
    );
    expect(() => trace(plain, { swatch: 'grey' as never })).toThrow(
      /swatch is grey, but must be light, middle or dark/,
    );
  });
  test('a texture of thousands of lines', () => {
    const hairs = Array.from({ length: 1500 }, (_, i) =>
      straight(10 + 16 * (i % 50), 8 + 14 * Math.floor(i / 50), 11, 30, 3),
    );
    expect(() => trace(photograph(hairs, { width: 820, height: 440 }))).toThrow(
      /seems to have 1\d\d\d strokes.*at most 1000/,
    );
  });
});
