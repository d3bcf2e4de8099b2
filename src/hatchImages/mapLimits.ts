/** Most texels per side of a map. */
export const MAX_SIDE = 4096;

/** Most tones of a map. More than 16 are hardly told apart. */
const MAX_TONES = 64;

/** Most texels of the finest level, all tones together. So many take about half a minute and half a gigabyte to prepare. */
const MAX_TEXELS = 4 * MAX_SIDE ** 2;

/** Says that a map has more tones than can be read, whatever their size. Undefined if it has not. */
export function excessOfTones(tones: number): string | undefined {
  return tones > MAX_TONES ? `has ${tones} tones, but at most ${MAX_TONES} are allowed; leave some out` : undefined;
}

/** Says that a map is larger than can be read: the rest of a sentence that begins with its name. Undefined if it is not. */
export function excessOf(tones: number, size: number): string | undefined {
  if (tones * size ** 2 <= MAX_TEXELS) return excessOfTones(tones);
  return `has ${tones} tones of ${size} × ${size} texels, but at most ${MAX_TEXELS / size ** 2} of that size are allowed; make the images smaller, or leave some out`;
}
