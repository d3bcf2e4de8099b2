import type { DecodedPicture } from '../common/Surroundings.js';

/** Statistics of a picture's alpha, in [0, 1]. */
export interface PictureAlpha {
  /** Mean alpha of all pixels. */
  mean: number;
  /** The half-transparent share of the pixels that are not transparent. */
  half: number;
}

/** Pictures with a larger half-transparent share count as see-through. */
const MOST_HALF = 0.5;
/** Pictures with a higher mean alpha are opaque. */
const OPAQUE = 0.999;
/** Pixels with lower alpha are transparent, with higher alpha opaque. */
const [CLEAR, SOLID] = [0.1, 0.9];
/** The maximum width and height at which pictures are sampled. */
const SIDE = 128;

/** The alpha statistics of a picture; undefined if its pixels cannot be read. */
export function alphaOf(picture: DecodedPicture): PictureAlpha | undefined {
  const scale = 'data' in picture ? 1 : Math.min(1, SIDE / Math.max(picture.width, picture.height));
  const [width, height] = [picture.width, picture.height].map((side) => Math.max(1, Math.round(scale * side)));
  const data = pixelsOf(picture, width, height);
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

/** Whether a blended picture makes its surface see-through as a whole. */
export const isHalfThere = ({ half, mean }: PictureAlpha): boolean => half > MOST_HALF || mean === 0;

export const isOpaque = ({ mean }: PictureAlpha): boolean => mean > OPAQUE;

/** The pixels of a picture resized to a width and height; undefined if they cannot be read. */
export function pixelsOf(picture: DecodedPicture, width: number, height: number): Uint8ClampedArray | undefined {
  if ('data' in picture)
    return picture.width === width && picture.height === height ? picture.data : sampled(picture, width, height);
  if (typeof OffscreenCanvas === 'undefined') return undefined;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context?.drawImage(picture, 0, 0, width, height);
  return context?.getImageData(0, 0, width, height).data;
}

/** Nearest-neighbour sampling. */
function sampled(
  { data, width: columns, height: rows }: Extract<DecodedPicture, { data: Uint8ClampedArray }>,
  width: number,
  height: number,
): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const column = Math.floor(((i % width) * columns) / width);
    const from = 4 * (Math.floor((Math.floor(i / width) * rows) / height) * columns + column);
    for (let k = 0; k < 4; k++) pixels[4 * i + k] = data[from + k];
  }
  return pixels;
}
