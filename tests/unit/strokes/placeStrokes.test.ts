import { describe, expect, it } from 'vitest';
import { type PlacementRequest, placeStrokes } from '../../../src/strokes/placeStrokes.js';
import type { Stroke } from '../../../src/strokes/Stroke.js';
import { resolveHatchImageOptions } from '../../../src/strokes/tamImages/generateHatchImages.js';
import { drawStrokes, finish, styleNames } from './draw.js';

const request = resolveHatchImageOptions;

/** Standard deviation of the mean ink of 8 × 8 blocks, for each tone and level. */
function unevenness({ size, tones, levels, ...request }: PlacementRequest): number[] {
  const strokes = finish(placeStrokes({ size, tones, levels, ...request }));
  const result: number[] = [];
  for (let tone = 1; tone < tones; tone++) {
    for (let level = 0; level < levels; level++) {
      const side = size >> level;
      const image = drawStrokes(
        strokes.filter((stroke) => stroke.tone <= tone && stroke.level >= level),
        side,
      );
      const blocks = new Array<number>(64).fill(0);
      for (let i = 0; i < image.length; i++) {
        const [row, column] = [Math.floor(i / side), i % side];
        blocks[8 * Math.floor((8 * row) / side) + Math.floor((8 * column) / side)] += 255 - image[i];
      }
      const mean = blocks.reduce((a, b) => a + b) / 64;
      result.push(Math.sqrt(blocks.reduce((sum, block) => sum + (block - mean) ** 2, 0) / 64));
    }
  }
  return result;
}

describe('placeStrokes', () => {
  it.each(styleNames)('spreads %s more evenly than chance: less than 0.8 of its unevenness', (style) => {
    const greedy = request({ style, size: 128, tones: 6 });
    const chance = unevenness({ ...greedy, style: { ...greedy.style, proposals: 1 } });
    const ratios = unevenness(greedy).map((value, i) => value / chance[i]);
    expect(ratios.reduce((a, b) => a + b) / ratios.length).toBeLessThan(0.8);
  });

  it.each(styleNames)('draws %s from light to dark, and within a tone from coarse to fine', (style) => {
    const strokes = finish(placeStrokes(request({ style, size: 64, tones: 5 })));
    const order = strokes.map(({ tone, level }) => 10 * tone - level);
    expect(order).toEqual(order.toSorted((a, b) => a - b));
    expect(new Set(strokes.map(({ tone }) => tone))).toEqual(new Set([1, 2, 3, 4]));
  });

  it('keeps strokes within the bounds of their style', () => {
    const { style, ...rest } = request({ style: 'crossHatching', size: 64 });
    for (const stroke of finish(placeStrokes({ style, ...rest }))) {
      expect(stroke.length).toBeGreaterThanOrEqual(style.length[0]);
      expect(stroke.length).toBeLessThanOrEqual(style.length[1]);
      expect(Math.abs(stroke.width / style.width - 1)).toBeLessThanOrEqual(style.widthSpread + 1e-12);
      expect(Math.abs(stroke.slope)).toBeLessThanOrEqual(style.slope);
    }
  });

  it('adds the perpendicular layer from about half tone on, and only to a cross-hatching', () => {
    const firstAcross = (style: 'hatching' | 'crossHatching'): number | undefined =>
      finish(placeStrokes(request({ style, size: 64, tones: 9 }))).find(({ across }) => across)?.tone;
    expect(firstAcross('hatching')).toBeUndefined();
    // Image 5 of 9 has 0.59 ink, image 4 has 0.475.
    expect([4, 5]).toContain(firstAcross('crossHatching'));
  });

  it('draws three directions sixty degrees apart, one after the other, for a triple hatching', () => {
    const strokes = finish(placeStrokes(request({ style: 'tripleHatching', size: 64, tones: 16 })));
    const degrees = ({ across, slope }: Stroke): number => (Math.atan(across ? 1 / slope : slope) * 180) / Math.PI;
    const first = [0, 1, 2].map((layer) => strokes.find((stroke) => stroke.layer === layer)!);
    expect(first.map(({ tone }) => tone)).toEqual(first.map(({ tone }) => tone).toSorted((a, b) => a - b));
    expect(new Set(first.map(({ tone }) => tone)).size).toBe(3);
    const expected = [0, 60, -60];
    for (const stroke of strokes) expect(Math.abs(degrees(stroke) - expected[stroke.layer])).toBeLessThan(2);
  });

  it('draws dots for a stippling', () => {
    const strokes = finish(placeStrokes(request({ style: 'stippling', size: 64, tones: 4 })));
    expect(strokes.every(({ length }) => length === 0)).toBe(true);
  });

  it.each(styleNames)('draws %s in pairs that a half turn swaps, if asked', (style) => {
    const strokes = finish(placeStrokes({ ...request({ style, size: 64 }), pairs: true }));
    expect(strokes.length % 2).toBe(0);
    const ink = drawStrokes(strokes, 64);
    expect(ink.filter((byte, i) => byte !== ink[ink.length - 1 - i]).length).toBe(0);
    for (let i = 0; i < strokes.length; i += 2) {
      const [one, other] = [strokes[i], strokes[i + 1]];
      expect([other.u, other.v, other.bow]).toEqual([1 - one.u, 1 - one.v, -one.bow]);
    }
  });

  it.each(styleNames)('reports progress that rises within [0, 1], often enough to be stopped: %s', (style) => {
    const progress = [...placeStrokes(request({ style }))];
    expect(progress.length).toBeGreaterThan(50);
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress[0]).toBeGreaterThan(0);
    expect(progress.at(-1)).toBeLessThanOrEqual(1);
  });
});
