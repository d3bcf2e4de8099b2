import { describe, expect, it } from 'vitest';
import { placeStrokes } from '../../../../src/strokes/placeStrokes.js';
import type { Stroke } from '../../../../src/strokes/Stroke.js';
import { strokeStyles } from '../../../../src/strokes/strokeStyles.js';
import { checkHatchImages } from '../../../../src/strokes/tamImages/checkHatchImages.js';
import {
  generateHatchImages,
  type MapRequest,
  resolveHatchImageOptions,
} from '../../../../src/strokes/tamImages/generateHatchImages.js';
import { cases } from '../../../selection.mjs';
import { drawStrokes, finish, hatchImages, styleNames } from '../draw.js';

/** The report on the map of each request. */
const reports = new Map<MapRequest, ReturnType<typeof checkHatchImages>>();

function reportOf(request: MapRequest) {
  const report = reports.get(request) ?? checkHatchImages(hatchImages(request));
  reports.set(request, report);
  return report;
}

/** Every style, the sizes and tones between which everything lies, thin and thick strokes. */
const matrix: MapRequest[] = styleNames.flatMap((style) => [
  { style },
  { style, size: 64, tones: 4, seed: 2 },
  { style, size: 128, tones: 16, seed: 3, strokeTexels: strokeStyles[style].widthRange[1] },
  { style, size: 128, tones: 5, seed: 4, strokeTexels: strokeStyles[style].widthRange[0] },
]);
for (const style of ['hatching', 'stippling', 'charcoal'] as const) {
  matrix.push({ style, size: 512, tones: 4, levels: 2, seed: 5 });
}

describe.each(
  cases(
    matrix.filter(({ size = 256, style }) => size === 64 || (style === 'hatching' && size === 256)),
    matrix,
  ),
)('generateHatchImages(%o)', { tags: ['more'] }, (options) => {
  const { style, size, tones, levels } = resolveHatchImageOptions(options);
  const report = () => reportOf(options);

  it('has the mean ink of its tone on every level, to within a stroke', () => {
    for (const [tone, row] of report().means.entries()) {
      for (const [level, mean] of row.entries()) {
        const side = size >> level;
        const stroke = (style.width * (style.length[1] + style.width / side)) / side;
        const tolerance = side >= 128 ? 0.005 : Math.max(0.01, stroke);
        expect(Math.abs(mean - (style.maxInk * tone) / (tones - 1))).toBeLessThanOrEqual(tolerance);
      }
    }
  });

  it('has the same mean over the levels of a tone', () => {
    for (const row of report().means) {
      const large = row.filter((_, level) => size >> level >= 64);
      expect(Math.max(...large) - Math.min(...large)).toBeLessThanOrEqual(0.02);
    }
  });

  it('nests in tone and in level, without a single violation', () => {
    const { toneNesting, levelNesting, consistent } = report();
    expect(toneNesting).toEqual(toneNesting.map((row) => row.map(() => 0)));
    expect(levelNesting).toEqual(levelNesting.map((row) => row.map(() => 0)));
    expect(consistent).toBe(true);
  });

  it('starts with blank paper and has every image asked for', () => {
    const { images } = hatchImages(options);
    expect(images.map((row) => row.map((image) => image.length))).toEqual(
      Array.from({ length: tones }, () => Array.from({ length: levels }, (_, level) => (size >> level) ** 2)),
    );
    expect(images[0].every((image) => image.every((byte) => byte === 255))).toBe(true);
  });
});

describe('generateHatchImages', () => {
  it.each(styleNames)('gives the same bytes for the same seed, others for another (%s)', (style) => {
    const draw = (seed: number) => finish(generateHatchImages({ style, size: 64, tones: 4, seed })).images;
    expect(draw(5)).toEqual(draw(5));
    expect(draw(5)).not.toEqual(draw(6));
  });

  it('draws a default map of 8 tones, 256 texels, 5 levels', () => {
    const { size, images } = hatchImages({ style: 'hatching' });
    expect([size, images.length, images[0].length]).toEqual([256, 8, 5]);
    expect(finish(generateHatchImages())).toEqual(hatchImages({ style: 'hatching' }));
  });

  it.each(cases(styleNames.slice(0, 2), styleNames))(
    'draws strokes as wide on every level (%s)',
    { tags: ['more'] },
    (style) => {
      const request = resolveHatchImageOptions({ style });
      const strokes = finish(placeStrokes(request));
      // In the middle, where a line has its full width, beyond the effect of the grid of texels.
      const excess = Array.from({ length: request.levels }, (_, level) => {
        const side = request.size >> level;
        const along = strokes.filter((stroke) => stroke.level >= level && stroke.layer === 0 && stroke.tone === 1);
        return median(along.slice(0, 40).map((stroke) => inkAcross(stroke, side) - stroke.width));
      });
      expect(Math.max(...excess) - Math.min(...excess)).toBeLessThanOrEqual(0.25);
      expect(Math.abs(excess[0])).toBeLessThanOrEqual(0.25);
    },
  );

  it.each<[MapRequest, RegExp]>([
    [{ style: 'oil' as 'hatching' }, /style is oil, but must be one of hatching, crossHatching, .*, woodcut\.$/],
    [{ style: 'toString' as 'hatching' }, /style is toString/],
    [{ seed: 0.5 }, /seed is 0\.5, but must be a whole number/],
    [{ seed: Number.NaN }, /seed is NaN/],
    [{ size: 100 }, /size is 100, but must be 64, 128, 256, 512 or 1024/],
    [{ size: 2048 }, /size is 2048/],
    [{ tones: 3 }, /tones is 3, but must be a whole number from 4 to 16/],
    [{ tones: 17 }, /tones is 17/],
    [{ size: 64, levels: 4 }, /levels is 4, but must be a whole number from 1 to 3 at size 64/],
    [{ levels: 0 }, /levels is 0/],
    [{ strokeTexels: 0 }, /strokeTexels is 0, but must be a number from 1\.2 to 2\.6 texels for style hatching/],
    [{ style: 'stippling', strokeTexels: 1.2 }, /strokeTexels is 1\.2, but must be a number from 1\.65 to 2\.5/],
  ])('refuses %o', (options, message) => {
    expect(() => generateHatchImages(options).next()).toThrow(RangeError);
    expect(() => generateHatchImages(options).next()).toThrow(message);
  });
});

/** Ink in the column through the middle of a stroke along u, drawn alone, in texels. */
function inkAcross(stroke: Stroke, size: number): number {
  const image = drawStrokes([stroke], size);
  const column = Math.floor(stroke.u * size);
  let ink = 0;
  for (let row = 0; row < size; row++) ink += 1 - image[row * size + column] / 255;
  return ink;
}

function median(values: number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1];
}
