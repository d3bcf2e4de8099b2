import type { DecodedPicture } from '../common/Surroundings.js';

/** How much alpha a picture has, each from 0 to 1. */
export interface PictureAlpha {
  /** Over all of it. */
  mean: number;
  /** The share of it that is half there, of what is there at all. */
  half: number;
}

/** A pixel is not there with less alpha, and wholly with more. */
const [CLEAR, SOLID] = [0.1, 0.9];
/** A bitmap is looked at in this size at most. */
const SIDE = 128;

/** The alpha of a picture; undefined where its pixels cannot be read. */
export function alphaOf(picture: DecodedPicture): PictureAlpha | undefined {
  const data = 'data' in picture ? picture.data : pixelsOf(picture);
  if (!data) return undefined;
  let [sum, clear, solid] = [0, 0, 0];
  for (let i = 3; i < data.length; i += 4) {
    const alpha = data[i] / 255;
    sum += alpha;
    if (alpha < CLEAR) clear++;
    else if (alpha > SOLID) solid++;
  }
  const count = data.length / 4;
  return { mean: sum / count, half: count > clear ? 1 - solid / (count - clear) : 0 };
}

function pixelsOf(bitmap: ImageBitmap): Uint8ClampedArray | undefined {
  if (typeof OffscreenCanvas === 'undefined') return undefined;
  const scale = Math.min(1, SIDE / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(scale * side)));
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context?.drawImage(bitmap, 0, 0, width, height);
  return context?.getImageData(0, 0, width, height).data;
}
