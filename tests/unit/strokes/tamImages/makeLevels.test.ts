import { describe, expect, it } from 'vitest';
import { checkHatchImages } from '../../../../src/strokes/tamImages/checkHatchImages.js';
import type { HatchImages } from '../../../../src/strokes/tamImages/HatchImages.js';
import { makeLevels } from '../../../../src/strokes/tamImages/makeLevels.js';
import { finish, hatchImages } from '../draw.js';

type Style = 'hatching' | 'stippling' | 'pencil';
const made = new Map<Style, HatchImages>();

/** The finest images of a map, as an artist might have drawn them, with the levels that are made for them, once for each style. */
const madeOf = (style: Style): HatchImages => {
  const known = made.get(style);
  if (known) return known;
  const { size, images } = hatchImages({ style });
  const levels = finish(makeLevels({ size, images: images.map(([finest]) => [finest]) }));
  made.set(style, levels);
  return levels;
};

describe.each(['hatching', 'stippling', 'pencil'] as const)('makeLevels of %s', (style) => {
  it('keeps the images and adds levels down to 16 texels', () => {
    const { images } = madeOf(style);
    expect(images.map((row) => row.map(({ length }) => Math.sqrt(length)))).toEqual(
      images.map(() => [256, 128, 64, 32, 16]),
    );
    expect(images.map(([finest]) => finest)).toEqual(hatchImages({ style }).images.map(([finest]) => finest));
    expect(images[0].every((image) => image.every((byte) => byte === 255))).toBe(true);
  });

  it('keeps the mean of each tone, and nests in tone and level', () => {
    const { means, toneNesting, levelNesting } = checkHatchImages(madeOf(style));
    for (const row of means) for (const mean of row) expect(Math.abs(mean - row[0])).toBeLessThan(0.02);
    expect(toneNesting.flat().every((count) => count === 0)).toBe(true);
    const texels = 128 ** 2 + 64 ** 2 + 32 ** 2 + 16 ** 2;
    for (const row of levelNesting) expect(row.reduce((a, b) => a + b) / texels).toBeLessThan(0.01);
  });

  it('keeps black black and white white: strokes do not fade', () => {
    const { images } = madeOf(style);
    for (const row of images.slice(1)) {
      for (const image of row.slice(1, 4)) {
        const extreme = image.filter((byte) => byte < 64 || byte > 191).length / image.length;
        expect(extreme).toBeGreaterThan(0.6);
      }
    }
  });
});

describe('makeLevels', () => {
  it('keeps lines about two texels wide on every level', () => {
    const { images } = madeOf('hatching');
    for (const [level, image] of images[2].entries()) {
      const size = 256 >> level;
      if (size < 32) continue;
      const runs: number[] = [];
      for (let column = 0; column < size; column++) {
        let run = 0;
        for (let row = 0; row < size; row++) {
          const isInk = image[row * size + column] < 128;
          if (!isInk && run > 0) runs.push(run);
          run = isInk ? run + 1 : 0;
        }
      }
      const mean = runs.reduce((a, b) => a + b) / runs.length;
      expect(mean).toBeGreaterThan(1.3);
      expect(mean).toBeLessThan(2.8);
    }
  });

  it('adds no levels to tiles of 16 texels or fewer', () => {
    const images = [[new Uint8Array(64).fill(255)], [new Uint8Array(64)]];
    expect(finish(makeLevels({ size: 8, images }))).toEqual({ size: 8, images });
  });
});
