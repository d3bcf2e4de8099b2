import { describe, expect, it } from 'vitest';
import { placeStrokes } from '../../../src/strokes/placeStrokes.js';
import { rasterizeStroke } from '../../../src/strokes/rasterizeStroke.js';
import type { Stroke } from '../../../src/strokes/Stroke.js';
import { resolveHatchImageOptions } from '../../../src/strokes/tamImages/generateHatchImages.js';
import { drawStrokes, finish, styleNames } from './draw.js';

const stroke = (values: Partial<Stroke>): Stroke => ({
  u: 0.5,
  v: 0.5,
  layer: 0,
  across: false,
  length: 0,
  slope: 0,
  bow: 0,
  wave: 0,
  width: 2,
  taper: 0,
  pressure: 1,
  tone: 1,
  level: 0,
  ...values,
});

/** Ink in percent, row by row. */
const percent = (image: Uint8Array, size: number): number[][] =>
  Array.from({ length: size }, (_, row) =>
    Array.from({ length: size }, (_, column) => Math.round(100 * (1 - image[row * size + column] / 255))),
  );

describe('rasterizeStroke', () => {
  it('covers what the line covers: width 2.5 around the middle of row 2, round ends', () => {
    const image = drawStrokes([stroke({ length: 0.25, width: 2.5, v: 2.5 / 8, u: 4 / 8 })], 8);
    expect(percent(image, 8).slice(0, 6)).toEqual([
      [0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 63, 75, 75, 63, 0, 0],
      [0, 25, 100, 100, 100, 100, 25, 0],
      [0, 0, 63, 75, 75, 63, 0, 0],
      [0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 0, 0, 0, 0, 0, 0],
    ]);
  });

  it('runs along v when it lies across', () => {
    const along = percent(drawStrokes([stroke({ length: 0.5, u: 0.3, v: 0.4, slope: 0.2, bow: 0.05 })], 16), 16);
    const across = percent(
      drawStrokes([stroke({ length: 0.5, u: 0.4, v: 0.3, slope: 0.2, bow: 0.05, across: true })], 16),
      16,
    );
    expect(across).toEqual(along[0].map((_, column) => along.map((row) => row[column])));
  });

  it('wraps around', () => {
    const image = percent(drawStrokes([stroke({ length: 0.5, u: 0, v: 0, width: 1 })], 8), 8);
    expect(image[0]).toEqual([50, 50, 29, 0, 0, 29, 50, 50]);
    expect(image[7]).toEqual(image[0]);
    expect(
      image
        .slice(1, 7)
        .flat()
        .every((ink) => ink === 0),
    ).toBe(true);
  });

  it('narrows towards its ends to one texel', () => {
    const image = percent(drawStrokes([stroke({ length: 0.8, v: 16.5 / 32, width: 2.4, taper: 6 })], 32), 32);
    // Column sums: the width of the line there.
    const widths = image[0].map((_, column) => image.reduce((sum, row) => sum + row[column], 0) / 100);
    expect(widths[16]).toBeCloseTo(2.4, 1);
    expect(widths[4]).toBeLessThan(1.6);
    expect(widths[4]).toBeGreaterThanOrEqual(0.99);
    for (let column = 4; column < 16; column++) expect(widths[column + 1]).toBeGreaterThanOrEqual(widths[column]);
  });

  it('returns the decrease of the sum of bytes, and only darkens', () => {
    const image = new Uint8Array(32 * 32).fill(255);
    let sum = 255 * image.length;
    for (const width of [1.5, 2.5, 1.5]) {
      const before = image.slice();
      sum -= rasterizeStroke(image, 32, stroke({ length: 0.7, slope: 0.05, width }));
      expect(image.reduce((a, b) => a + b, 0)).toBe(sum);
      expect(image.every((byte, i) => byte <= before[i])).toBe(true);
    }
  });

  it('does not depend on the order of drawing', () => {
    const strokes = [
      stroke({ length: 0.6, slope: 0.1 }),
      stroke({ length: 0.4, across: true }),
      stroke({ width: 2.7 }),
    ];
    expect(drawStrokes(strokes, 32)).toEqual(drawStrokes(strokes.toReversed(), 32));
  });

  it.each(styleNames)('is toroidal: %s moved by whole texels is the same image, rolled', (style) => {
    const strokes = finish(placeStrokes(resolveHatchImageOptions({ style, size: 64, tones: 4 })));
    for (const [level, right, down] of [
      [0, 17, 45],
      [1, 5, 31],
      [2, 15, 1],
    ] as const) {
      const size = 64 >> level;
      const shown = strokes.filter((one) => one.level >= level && one.tone <= 2);
      const image = drawStrokes(shown, size);
      const moved = drawStrokes(
        shown.map((one) => ({ ...one, u: one.u + right / size, v: one.v + down / size })),
        size,
      );
      let worst = 0;
      for (let row = 0; row < size; row++) {
        for (let column = 0; column < size; column++) {
          const rolled = ((row + down) % size) * size + ((column + right) % size);
          worst = Math.max(worst, Math.abs(moved[rolled] - image[row * size + column]));
        }
      }
      expect(worst).toBeLessThanOrEqual(1);
    }
  });
});
