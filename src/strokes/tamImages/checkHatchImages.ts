import { DEFAULT_STROKE_TEXELS, excessOf, type HatchImages, MAX_SIDE } from './HatchImages.js';

/** How well hatch images keep the constraints of Suarez et al., section 3.1. Images that break them can still be drawn. */
export interface HatchImageReport {
  /** `means[tone][level]`: mean ink, 0 = paper, 1 = ink. It should be the same on all levels and grow with the tone. */
  means: number[][];
  /** `toneNesting[tone][level]`: number of texels that are lighter than in the previous tone by more than 1/255. Row 0 is zero. */
  toneNesting: number[][];
  /**
   * `levelNesting[tone][level]`: number of texels with at least half ink for which the next finer level has no texel with half ink
   * at the same place (the 2 × 2 block and the texels around it). Column 0 is zero.
   */
  levelNesting: number[][];
  /** The images whose mean ink is below that of the previous tone on the same level. */
  meansOutOfOrder: { tone: number; level: number }[];
  /** Whether both kinds of nesting hold everywhere and all means are in order. */
  consistent: boolean;
}

/**
 * Checks that images have the shape of a tonal art map.
 *
 * @throws TypeError or RangeError that names the fault and its place
 */
export function assertHatchImages(hatchImages: HatchImages): void {
  const fail = (Fault: typeof TypeError | typeof RangeError, text: string): never => {
    throw new Fault(`TonalArtMap.fromHatchImages: ${text}`);
  };
  if (typeof hatchImages !== 'object' || hatchImages === null) {
    fail(TypeError, `expected { size, images }, but got ${String(hatchImages)}.`);
  }
  const { size, images, strokeTexels = DEFAULT_STROKE_TEXELS } = hatchImages;
  if (!Number.isInteger(size) || size < 1 || size > MAX_SIDE || (size & (size - 1)) !== 0) {
    fail(
      RangeError,
      `size is ${String(size)}, but must be a power of two from 1 to ${MAX_SIDE} (texels per side of level 0).`,
    );
  }
  if (!(strokeTexels > 0 && strokeTexels < Infinity)) {
    fail(RangeError, `strokeTexels is ${String(strokeTexels)}, but must be a width in texels above 0.`);
  }
  if (!Array.isArray(images) || images.length < 2) {
    fail(TypeError, 'images must be an array with at least two tones, the lightest first: images[tone][level].');
  }
  const excess = excessOf(images.length, size);
  if (excess) fail(RangeError, `the map ${excess}.`);
  const levels = Array.isArray(images[0]) ? images[0].length : 0;
  const allLevels = Math.log2(size) + 1;
  for (const [tone, row] of images.entries()) {
    if (!Array.isArray(row) || row.length === 0) {
      fail(TypeError, `images[${tone}] must be an array with one image per level, the finest first.`);
    }
    if (row.length !== levels) {
      fail(
        RangeError,
        `images[${tone}] has ${row.length} levels, but images[0] has ${levels}; give every tone the same.`,
      );
    }
    if (levels > allLevels) {
      fail(
        RangeError,
        `there are ${levels} levels, but size ${size} allows at most ${allLevels} (each half the one before).`,
      );
    }
    for (const [level, image] of row.entries()) {
      const side = size >> level;
      if (!(image instanceof Uint8Array)) {
        fail(TypeError, `images[${tone}][${level}] must be a Uint8Array with one byte per texel, 255 = paper.`);
      }
      if (image.length === 0) {
        fail(
          TypeError,
          `images[${tone}][${level}] is empty: its buffer was transferred, or it never had any bytes. Pass a copy that you do not transfer: image.slice().`,
        );
      }
      if (image.length !== side * side) {
        fail(
          RangeError,
          `images[${tone}][${level}] has ${image.length} bytes, but level ${level} of size ${size} needs ${side} × ${side} = ${side * side}, one per texel.`,
        );
      }
    }
  }
}

/** Measures how well images keep the constraints. They must have passed `assertHatchImages`. */
export function checkHatchImages({ size, images }: HatchImages): HatchImageReport {
  const means = images.map((row) => row.map(meanInk));
  const toneNesting = images.map((row, tone) =>
    row.map((image, level) => (tone === 0 ? 0 : countLighterTexels(images[tone - 1][level], image))),
  );
  const levelNesting = images.map((row) =>
    row.map((image, level) => (level === 0 ? 0 : findLostInk(image, row[level - 1], size >> level).length)),
  );
  const meansOutOfOrder = means.flatMap((row, tone) =>
    row.flatMap((mean, level) => (tone > 0 && mean < means[tone - 1][level] ? [{ tone, level }] : [])),
  );
  const isZero = (count: number): boolean => count === 0;
  return {
    means,
    toneNesting,
    levelNesting,
    meansOutOfOrder,
    consistent: toneNesting.flat().every(isZero) && levelNesting.flat().every(isZero) && meansOutOfOrder.length === 0,
  };
}

/** Mean ink of an image, 0 = paper, 1 = ink. */
export function meanInk(image: Uint8Array): number {
  let sum = 0;
  for (let i = 0; i < image.length; i++) sum += image[i];
  return 1 - sum / (255 * image.length);
}

function countLighterTexels(lighter: Uint8Array, darker: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < darker.length; i++) if (darker[i] > lighter[i] + 1) count++;
  return count;
}

/** The largest byte that counts as at least half ink. */
export const HALF_INK = 127;

/**
 * Finds the places where the nesting of two levels is broken: texels of the coarser level with at least half ink for which the
 * finer level has no texel with half ink at the same place (the 2 × 2 block and the texels around it).
 *
 * @param coarse size² bytes
 * @param fine (2·size)² bytes
 * @returns for each such place the index of its darkest texel in `fine`
 */
export function findLostInk(coarse: Uint8Array, fine: Uint8Array, size: number): number[] {
  const fineSize = 2 * size;
  const mask = fineSize - 1;
  const lost: number[] = [];
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      if (coarse[row * size + column] > HALF_INK) continue;
      let darkest = 256;
      let place = 0;
      for (let y = 2 * row - 1; y <= 2 * row + 2; y++) {
        for (let x = 2 * column - 1; x <= 2 * column + 2; x++) {
          const texel = (y & mask) * fineSize + (x & mask);
          if (fine[texel] < darkest) {
            darkest = fine[texel];
            place = texel;
          }
        }
      }
      if (darkest > HALF_INK) lost.push(place);
    }
  }
  return lost;
}
