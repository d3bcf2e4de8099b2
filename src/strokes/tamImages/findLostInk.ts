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
