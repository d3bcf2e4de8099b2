import { describe, expect, it } from 'vitest';
import { blockTones } from '../../../../tools/metrics/measures/blockTones.js';
import { centreLines } from '../../../../tools/metrics/measures/centreLines.js';
import type { LocatedImage } from '../../../../tools/metrics/measures/reprojectedChange.js';
import { silhouetteDistances } from '../../../../tools/metrics/measures/silhouetteDistances.js';
import { wholeness } from '../../../../tools/metrics/measures/wholeness.js';
import { missedStrokes, withStrokes, worstWhole } from '../../../../tools/metrics/strokes.mjs';
import { picture, stripes } from './images.js';

/** Black where a point is nearer than half a width to one of the curves, with an edge a pixel wide. */
function drawn(size: number, curves: readonly ((share: number) => readonly [x: number, y: number])[], width: number) {
  const nearest = new Float32Array(size * size).fill(width);
  for (const [px, py] of curves.flatMap((curve) => Array.from({ length: 400 }, (_, i) => curve(i / 399)))) {
    for (let y = Math.floor(py - width); y <= py + width; y++)
      for (let x = Math.floor(px - width); x <= px + width; x++)
        nearest[y * size + x] = Math.min(nearest[y * size + x], Math.hypot(px - x, py - y));
  }
  return picture(size, size, (x, y) => Math.min(1, Math.max(0, nearest[y * size + x] - width / 2 + 0.5)));
}

const straight = (x: number, y: number, length: number, degrees: number) => (share: number) => {
  const turn = (degrees * Math.PI) / 180;
  return [x + share * length * Math.cos(turn), y + share * length * Math.sin(turn)] as const;
};
const arc = (radius: number, degrees: number) => (share: number) => {
  const turn = (share * degrees * Math.PI) / 180;
  return [60 + radius * Math.cos(turn), 60 + radius * Math.sin(turn)] as const;
};

describe('centreLines', () => {
  for (const [name, curve, length] of [
    ['straight strokes, level', straight(10, 60, 80, 0), 80],
    ['straight strokes at 17°', straight(10, 40, 80, 17), 80],
    ['straight strokes at 45°', straight(10, 30, 80, 45), 80],
    ['half a circle', arc(30, 180), 30 * Math.PI],
    ['most of a circle', arc(40, 300), (40 * Math.PI * 300) / 180],
  ] as const) {
    for (const width of [2, 4]) {
      it(`measures ${name}, ${width} pixels wide, along their middle`, () => {
        const lines = centreLines(drawn(120, [curve], width));
        expect(lines).toHaveLength(1);
        expect(Math.abs(lines[0].length / length - 1)).toBeLessThan(0.03);
        expect(Math.abs(lines[0].ink / (length * width) - 1)).toBeLessThan(0.1);
      });
    }
  }

  it('tells strokes apart, and gives the pixel in the middle of each', () => {
    const lines = centreLines(drawn(100, [straight(10, 20, 60, 0), straight(30, 50, 20, 90)], 3));
    expect(lines.map(({ length }) => Math.round(length / 10))).toEqual([6, 2]);
    const [first, second] = lines.map(({ middle }) => [middle % 100, Math.floor(middle / 100)]);
    expect(Math.hypot(first[0] - 40, first[1] - 20)).toBeLessThan(3);
    expect(Math.hypot(second[0] - 30, second[1] - 60)).toBeLessThan(3);
  });

  it('looks at the surface alone, and overlooks specks', () => {
    const cut = picture(
      100,
      20,
      (_, y) => (y === 10 ? 0 : 1),
      (x) => x < 50,
    );
    expect(centreLines(cut).map(({ length }) => length)).toEqual([49]);
    expect(centreLines(picture(9, 9, (x, y) => (x === 4 && y < 3 ? 0 : 1)))).toEqual([]);
  });
});

describe('wholeness', () => {
  const line = (length: number, ink = length, middle = 0) => ({ length, ink, middle });

  it('is 1 for whole strokes, and a third for strokes in thirds', () => {
    expect(wholeness([line(30), line(30)], 30, undefined)).toEqual({
      strokes: 2,
      byInk: 1,
      plain: 1,
      apart: 1,
      joined: 0,
    });
    const cut = wholeness([line(10), line(10), line(10)], 30, undefined);
    expect([cut.byInk, cut.plain]).toEqual([1 / 3, 1 / 3]);
  });

  it('weighs by ink, and says how much of it touches', () => {
    const { byInk, plain, apart, joined } = wholeness([line(5), line(5), line(5), line(40), line(100)], 40, undefined);
    expect([byInk, plain, apart]).toEqual([2.5, 0.125, 1]);
    expect(joined).toBeCloseTo(100 / 155);
  });

  it('leaves out what lies within one length of a silhouette', () => {
    const distances = [100, 39];
    expect(wholeness([line(40, 40, 0), line(5, 5, 1)], 40, distances)).toMatchObject({ strokes: 1, plain: 1 });
    expect(wholeness([line(5, 5, 1)], 40, distances).byInk).toBeNaN();
  });
});

describe('silhouetteDistances', () => {
  /** A plane seen straight on, a unit to a pixel, with a step in depth. */
  const located = (size: number, depth: (x: number, y: number) => number, isSurface: (x: number) => boolean) => {
    const image = picture(size, size, () => 1, isSurface);
    const places = new Float32Array(4 * size * size);
    for (let i = 0; i < size * size; i++) {
      const [x, y] = [i % size, Math.floor(i / size)];
      places.set([x, y, depth(x, y), 1], 4 * i);
    }
    const scale = 2 / size;
    const objectToClip = [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 0, 0, -1, -1, 0, 1];
    return { ...image, places, objectToClip } satisfies LocatedImage;
  };
  const flat = () => 0;

  it('is the distance to the end of the surface and to the border of the picture', () => {
    const distances = silhouetteDistances(located(60, flat, (x) => x < 30));
    expect([distances[30 * 60 + 20], distances[30 * 60 + 29], distances[3 * 60 + 15]]).toEqual([10, 1, 3]);
    expect(distances[30 * 60 + 40]).toBe(0);
  });

  it('sees where one part hides another, and no silhouette in a slope', () => {
    const step = silhouetteDistances(
      located(
        60,
        (x) => (x < 30 ? 0 : 20),
        () => true,
      ),
    );
    expect(step[30 * 60 + 20]).toBe(10);
    const slope = silhouetteDistances(
      located(
        60,
        (x) => 3 * x,
        () => true,
      ),
    );
    expect(slope[30 * 60 + 30]).toBe(29);
  });
});

describe('blockTones', () => {
  it('is 0 for a tone of a grey, and its distance for another', () => {
    const grey = picture(64, 64, () => 0.75);
    expect(blockTones(grey, 0.25)).toEqual({ blocks: 4, error: 0, bias: 0 });
    expect(blockTones(grey, 0.35)).toMatchObject({ error: expect.closeTo(0.1), bias: expect.closeTo(-0.1) });
  });

  it('tells uneven strokes from a wrong tone', () => {
    const halves = picture(64, 64, (x) => (x < 32 ? 0 : 1));
    expect(blockTones(halves, 0.5)).toEqual({ blocks: 4, error: 0.5, bias: 0 });
    expect(blockTones(stripes(64, 8, 0, 0.5), 0.5).error).toBe(0);
  });

  it('counts only blocks that show the surface alone', () => {
    expect(
      blockTones(
        picture(
          64,
          64,
          () => 0,
          (x) => x < 40,
        ),
        1,
      ),
    ).toEqual({ blocks: 2, error: 0, bias: 0 });
  });
});

const numbers = { length: 10, lengthSpread: 0, curvature: 0, taperStart: 0, taperEnd: 0.4, width: 0.5, widthSpread: 0 };
const spacings = { wobble: 0, angleSpread: 3, spacing: 1, spacingSpread: 0.2, clustering: 0, overlap: 0 };
const sheet = { ...numbers, ...spacings, crossingAngle: 0, crossingFrom: 1 };
const pictured = (byInk: number, plain: number, strokes = 30) => ({
  ...{ byInk, plain, strokes, apart: byInk, joined: 0, tone: 0.1, nearness: 1 },
});
const moved = (change: number) => ({ change, popping: 1 });
const motion = (change: number) => ({ zoom: moved(change), camera: moved(change), light: moved(change) });
const measured = {
  kind: 'rows' as const,
  whole: { sphere: { brush: [pictured(0.9, 0.7), pictured(0.85, 0.65), pictured(0.1, 0.1, 3)] } },
  atShadows: { brush: [pictured(0.88, 0.58)] },
  tones: {
    wall: { brush: { 0.1: { blocks: 9, error: 0.01, bias: -0.01 }, 0.5: { blocks: 9, error: 0.02, bias: 0.01 } } },
  },
  motion: { sphere: { lines: motion(0.02), brush: motion(0.02) } },
  numbers: { brush: { tone: 0.2, strokes: 40, sheet, wall: { ...sheet, length: 11.4, wobble: 0.015 } } },
};

describe('the strokes of hands', () => {
  it('are as required where nothing is missed; pictures of few strokes say nothing', () => {
    expect(missedStrokes(measured)).toEqual([]);
    expect(worstWhole(measured.whole.sphere.brush)).toEqual({ byInk: 0.85, plain: 0.65, apart: 0.85, joined: 0 });
  });

  it('are named with what each misses', () => {
    const missed = missedStrokes({
      ...measured,
      whole: { sphere: { brush: [pictured(0.79, 0.7), pictured(0.9, 0.5)] } },
      tones: { wall: { brush: { 0.1: { blocks: 9, error: 0.05, bias: 0.05 } } } },
      motion: { sphere: { lines: motion(0.02), brush: { ...motion(0.02), light: moved(0.03) } } },
      numbers: { brush: { ...measured.numbers.brush, wall: { ...sheet, length: 8.4, angleSpread: 4 } } },
    });
    expect(missed).toEqual([
      'brush on sphere, byInk: 0.79, required ≥ 0.8',
      'brush on sphere, plain: 0.50, required ≥ 0.6',
      'blocks on the wall: 0.050, required ≤ 0.02',
      'brush on sphere, light: 1.50 of lines, required ≤ 1',
      'brush, length: 8.400, on the sheet 10.000',
      'brush, angleSpread: 4.000, on the sheet 3.000',
    ]);
  });

  it('are described before the drawings as lines, and written anew in their place', () => {
    const page = '# Measured\n\nText.\n\n## Drawings as lines\n\nLines.\n';
    const once = withStrokes(page, measured);
    expect(once).toMatch(/^# Measured\n\nText\.\n\n## Strokes of hands\n/);
    expect(once).toMatch(/\n\n## Drawings as lines\n\nLines\.\n$/);
    expect(once).toContain('| brush | 0.85 (0.65), 0.85, 0.00 |');
    expect(withStrokes(once, measured)).toBe(once);
  });
});
