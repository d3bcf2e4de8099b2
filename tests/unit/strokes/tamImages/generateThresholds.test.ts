import { describe, expect, it } from 'vitest';
import { placeStrokes } from '../../../../src/strokes/placeStrokes.js';
import { type MapRequest, resolveHatchImageOptions } from '../../../../src/strokes/tamImages/generateHatchImages.js';
import { drawThresholdField, generateThresholds } from '../../../../src/strokes/tamImages/generateThresholds.js';
import type { ThresholdLevel } from '../../../../src/strokes/tamImages/thresholds.js';
import { finish, styleNames } from '../draw.js';

const drawn = new Map<string, ThresholdLevel[]>();

/** Levels of thresholds with these options, drawn once. */
function levelsOf(options: MapRequest): ThresholdLevel[] {
  const key = JSON.stringify(options);
  const known = drawn.get(key) ?? finish(generateThresholds(options));
  drawn.set(key, known);
  return known;
}

const median = (values: number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];

/** Φ⁻¹ of the thresholds, from the bytes. */
const gaussian = ({ encoded }: ThresholdLevel): Float64Array =>
  Float64Array.from(encoded, (byte) => (6 * byte) / 255 - 3);

/** Lengths of the runs of ink along columns, toroidal, in texels. */
function inkRuns({ thresholds, size }: ThresholdLevel, tone: number): number[] {
  const runs: number[] = [];
  for (let column = 0; column < size; column++) {
    const isInk = (row: number): boolean => thresholds[(row % size) * size + column] < tone;
    for (let row = 0; row < size; row++) {
      if (!isInk(row) || isInk(row + size - 1)) continue;
      let end = row;
      while (end < row + size && isInk(end)) end++;
      runs.push(end - row);
    }
  }
  return runs;
}

/**
 * The places where columns of a field cross a value: how many texels its rise or fall goes on there, and how far it gets
 * from one texel to the next at the crossing.
 */
function rampsAcross(field: Float64Array, size: number, value: number): { texels: number; step: number }[] {
  const ramps: { texels: number; step: number }[] = [];
  for (let column = 0; column < size; column++) {
    const at = (row: number): number => field[((row + size) % size) * size + column];
    for (let row = 0; row < size; row++) {
      const step = at(row + 1) - at(row);
      if (at(row) < value === at(row + 1) < value) continue;
      let [first, last] = [row, row + 1];
      while (row - first < size / 2 && (at(first) - at(first - 1)) * step > 0) first--;
      while (last - row < size / 2 && (at(last + 1) - at(last)) * step > 0) last++;
      ramps.push({ texels: last - first, step: Math.abs(step) });
    }
  }
  return ramps;
}

const matrix: MapRequest[] = [
  ...styleNames.map((style) => ({ style, size: 128 })),
  { style: 'hatching' },
  { style: 'crossHatching', size: 64, seed: 9, levels: 2, strokeTexels: 1.3 },
];

describe.each(matrix)('generateThresholds(%o)', (options) => {
  const { size, levels: count } = resolveHatchImageOptions(options);
  const levels = levelsOf(options);

  it('has a level of each size', () => {
    expect(levels.map((level) => level.size)).toEqual(Array.from({ length: count }, (_, level) => size >> level));
    for (const level of levels) expect(level.thresholds.length).toBe(level.size ** 2);
  });

  it('is uniformly distributed on every level: the share of texels below a tone is the tone', () => {
    for (const { thresholds } of levels) {
      const sorted = thresholds.toSorted();
      // Texels come in pairs; the distance is half a pair.
      const distance = sorted.reduce(
        (most, threshold, i) => Math.max(most, Math.abs(threshold - (i + 0.5) / sorted.length)),
        0,
      );
      expect(distance).toBeLessThanOrEqual(1 / sorted.length);
      expect(1 / sorted.length).toBeLessThanOrEqual(1 / 256);
    }
  });

  it('is the same after a half turn, in both forms', () => {
    for (const { thresholds, encoded } of levels) {
      // Counted, since a difference of arrays this long takes minutes to print.
      const last = thresholds.length - 1;
      expect(thresholds.filter((threshold, i) => threshold !== thresholds[last - i]).length).toBe(0);
      expect(encoded.filter((byte, i) => byte !== encoded[last - i]).length).toBe(0);
    }
  });

  it('rises across the edges of strokes over two texels or more, without jumps', () => {
    for (const level of levels.filter((one) => one.size >= 32)) {
      const field = gaussian(level);
      for (const edge of [-1.28, -0.67, 0, 0.67]) {
        const ramps = rampsAcross(field, level.size, edge);
        expect(median(ramps.map(({ texels }) => texels))).toBeGreaterThanOrEqual(2);
        // Two standard deviations of the whole field, from early ink to late, take more than a texel.
        expect(median(ramps.map(({ step }) => step))).toBeLessThan(1.8);
      }
    }
  });
});

describe('generateThresholds', () => {
  it.each(styleNames)('gives the same bytes for the same seed, others for another (%s)', (style) => {
    const draw = (seed: number) => finish(generateThresholds({ style, size: 64, seed }));
    expect(draw(3)).toEqual(draw(3));
    expect(draw(3)[0].encoded).not.toEqual(draw(4)[0].encoded);
  });

  it('does not depend on the number of tones of the images', () => {
    expect(levelsOf({ size: 64, tones: 4 })).toEqual(levelsOf({ size: 64, tones: 16 }));
  });

  it.each([
    ['hatching', 1.5, 2.5],
    ['stippling', 2, 3],
  ] as const)('draws strokes about as wide on every level while they are apart (%s)', (style, narrowest, widest) => {
    for (const level of levelsOf({ style, size: 256 }).filter(({ size }) => size >= 32)) {
      const runs = inkRuns(level, 0.25);
      const mean = runs.reduce((a, b) => a + b) / runs.length;
      expect(mean).toBeGreaterThan(narrowest);
      expect(mean).toBeLessThan(widest);
    }
  });

  it('adds strokes while light, then lets them swell', () => {
    const [level] = levelsOf({ style: 'hatching' });
    const perColumn = (tone: number): number => inkRuns(level, tone).length / level.size;
    expect(perColumn(0.25)).toBeGreaterThan(1.6 * perColumn(0.1));
    expect(perColumn(0.5)).toBeGreaterThan(1.2 * perColumn(0.25));
    expect(median(inkRuns(level, 0.75))).toBeGreaterThan(median(inkRuns(level, 0.5)));
  });

  it('crosses from about half tone on', () => {
    const [level] = levelsOf({ style: 'crossHatching' });
    // Ink that goes on up and down for 16 texels is a stroke of the second layer.
    const crossing = (tone: number): number => inkRuns(level, tone).filter((run) => run >= 16).length / level.size;
    expect(crossing(0.3)).toBeLessThan(0.1);
    expect(crossing(0.65)).toBeGreaterThan(0.5);
  });

  it.each(styleNames)('keeps the strokes of a level on the next finer one (%s)', (style) => {
    const levels = levelsOf({ style, size: 128 });
    for (let l = 1; l < 3; l++) {
      const [fine, coarse] = [levels[l - 1], levels[l]];
      // Near the middle of a stroke of the coarse level, ink comes early on the finer one too.
      const tone = 0.15;
      let hearts = 0;
      let kept = 0;
      for (let row = 0; row < coarse.size; row++) {
        for (let column = 0; column < coarse.size; column++) {
          if (coarse.thresholds[row * coarse.size + column] >= 0.03) continue;
          hearts++;
          let earliest = 1;
          for (let y = 2 * row - 1; y <= 2 * row + 2; y++) {
            for (let x = 2 * column - 1; x <= 2 * column + 2; x++) {
              const mask = fine.size - 1;
              earliest = Math.min(earliest, fine.thresholds[(y & mask) * fine.size + (x & mask)]);
            }
          }
          if (earliest < tone) kept++;
        }
      }
      expect(hearts).toBeGreaterThan(20);
      // The grain of the paper may hide the middle of a stroke.
      expect(kept / hearts).toBeGreaterThan(resolveHatchImageOptions({ style }).style.grain ? 0.9 : 0.97);
    }
  });

  it.each(styleNames)('is as dark everywhere on the tile (%s)', (style) => {
    const [{ thresholds, size }] = levelsOf({ style, size: 128 });
    const blocks = new Array<number>(16).fill(0);
    for (let i = 0; i < thresholds.length; i++) {
      const [row, column] = [Math.floor(i / size), i % size];
      blocks[4 * Math.floor((4 * row) / size) + Math.floor((4 * column) / size)] += (16 * thresholds[i]) / size ** 2;
    }
    for (const mean of blocks) expect(Math.abs(mean - 0.5)).toBeLessThan(0.04);
  });

  it.each(styleNames)('reaches every place with a stroke (%s)', (style) => {
    const request = resolveHatchImageOptions({ style, size: 128 });
    const placement = { ...request, style: { ...request.style, ...request.style.thresholds } };
    const strokes = finish(placeStrokes({ ...placement, tones: 25, pairs: true }));
    for (let level = 0; level < request.levels; level++) {
      const size = request.size >> level;
      const field = new Float32Array(size * size).fill(Number.POSITIVE_INFINITY);
      for (const stroke of strokes) if (stroke.level >= level) drawThresholdField(field, size, 1, stroke, 0.5, 0.1);
      expect(field.every(Number.isFinite)).toBe(true);
    }
  });

  it('reports progress that rises within [0, 1], often enough to be stopped', () => {
    const progress = [...generateThresholds()];
    expect(progress.length).toBeGreaterThan(20);
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress.at(-1)).toBeLessThanOrEqual(1);
  });

  it('throws for an option out of its range', () => {
    expect(() => generateThresholds({ size: 100 }).next()).toThrow('TonalArtMap.generate: size is 100');
  });
});
