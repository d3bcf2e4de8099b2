import { findLostInk, HALF_INK } from './findLostInk.js';
import type { HatchImages } from './HatchImages.js';

/**
 * Repairs the nesting of levels at all places where ink of a coarser level is missing from the finer one (`findLostInk`): a texel
 * there becomes half ink, in this tone and in every darker one. Nothing becomes lighter, so tones stay nested.
 *
 * @param images changed in place
 */
export function enforceLevelNesting({ size, images }: HatchImages): void {
  for (const [tone, row] of images.entries()) {
    for (let level = row.length - 1; level > 0; level--) {
      for (const texel of findLostInk(row[level], row[level - 1], size >> level)) {
        for (let darker = tone; darker < images.length; darker++) {
          const image = images[darker][level - 1];
          image[texel] = Math.min(HALF_INK, image[texel]);
        }
      }
    }
  }
}
