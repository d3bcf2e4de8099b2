import type { DecodedPicture, Surroundings } from '../common/Surroundings.js';
import { alphaOf, pixelsOf } from './alphaOf.js';

/** A mask with a mean alpha below this says by that what is there. */
const OPAQUE = 0.99;
const GREEN = 1;
const ALPHA = 3;

/**
 * A picture with the lightness of another as its alpha, or with its alpha if that says anything.
 *
 * @param picture undefined for plain white
 * @param isInverted whether the mask says what is not there
 * @returns undefined where pixels cannot be read
 */
export async function masked(
  picture: DecodedPicture | undefined,
  mask: DecodedPicture,
  decodePicture: Surroundings['decodePicture'],
  isInverted = false,
): Promise<DecodedPicture | undefined> {
  const { width, height } = picture ?? mask;
  const alphas = pixelsOf(mask, width, height);
  const colors = picture ? pixelsOf(picture, width, height) : new Uint8ClampedArray(4 * width * height).fill(255);
  if (!alphas || !colors) return undefined;
  const data = colors.slice();
  const channel = (alphaOf(mask)?.mean ?? 1) < OPAQUE ? ALPHA : GREEN;
  for (let i = 0; i < data.length; i += 4)
    data[i + ALPHA] = isInverted ? 255 - alphas[i + channel] : alphas[i + channel];
  return decodePicture({ data, width, height }, { width, height, flipY: false });
}
