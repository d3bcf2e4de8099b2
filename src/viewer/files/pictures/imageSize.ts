import type { DecodedPicture } from '../common/Surroundings.js';

/** Width and height in pixels, from the header of a PNG, JPEG, WebP, BMP or GIF image. Undefined for anything else. */
export function imageSize(bytes: Uint8Array): [width: number, height: number] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (at: number): string => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (bytes.length < 30) return undefined;
  if (text(1) === 'PNG\r') return [view.getUint32(16), view.getUint32(20)];
  if (text(0) === 'RIFF' && text(8) === 'WEBP') return webpSize(view, text(12));
  if (view.getUint16(0) === 0xffd8) return jpegSize(view);
  if (text(0).startsWith('BM')) return positive(view.getInt32(18, true), Math.abs(view.getInt32(22, true)));
  if (text(0) === 'GIF8') return positive(view.getUint16(6, true), view.getUint16(8, true));
  return undefined;
}

const positive = (width: number, height: number): [number, number] | undefined =>
  width > 0 && height > 0 ? [width, height] : undefined;

function webpSize(view: DataView, kind: string): [number, number] | undefined {
  const u24 = (at: number): number => view.getUint16(at, true) | (view.getUint8(at + 2) << 16);
  if (kind === 'VP8X') return [u24(24) + 1, u24(27) + 1];
  if (kind === 'VP8 ') return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
  if (kind !== 'VP8L') return undefined;
  const bits = view.getUint32(21, true);
  return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
}

/** Skips JPEG markers up to the start of a frame. */
function jpegSize(view: DataView): [number, number] | undefined {
  for (let at = 2; at + 9 < view.byteLength; ) {
    const marker = view.getUint16(at);
    const startsFrame = marker >= 0xffc0 && marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker);
    if (startsFrame) return [view.getUint16(at + 7), view.getUint16(at + 5)];
    if (marker < 0xff00) return undefined;
    // Any number of fill bytes may precede a marker.
    at += marker === 0xffff ? 1 : 2 + view.getUint16(at + 2);
  }
  return undefined;
}

/** The maximum number of pixels of one picture: a file of 44 kilobytes can decode to a gigabyte. */
const MAX_PIXELS = 2 ** 26;
/** The maximum number of pixels of all pictures of a model at file size. They are decoded one at a time. */
const MAX_TOTAL_PIXELS = 2 ** 28;
/** The maximum number of pixels of all pictures as drawn: eight of 2,048 pixels square take 171 megabytes with their mipmaps. */
const MAX_DRAWN_PIXELS = 2 ** 25;
const MAX_DRAWN_SIDE = 4096;

/** The size of a picture: of the file, and after {@link fitPictures} the size to draw it in. */
export interface PictureSize {
  width: number;
  height: number;
  /** Whether it is drawn smaller than in the file. */
  isReduced: boolean;
}

/** Adds up pixels of pictures, and checks whether another may be decoded. */
export class PixelBudget {
  private total = 0;

  /** Counts a picture. @returns whether it is within the limits */
  take(width: number, height: number): boolean {
    const pixels = width * height;
    if (pixels > MAX_PIXELS || this.total + pixels > MAX_TOTAL_PIXELS) return false;
    this.total += pixels;
    return true;
  }
}

/** Reduces the sizes of pictures until they fit together. @returns notes for the caption, if any was reduced */
export function fitPictures(pictures: readonly PictureSize[]): string[] {
  const given = pictures.map((picture) => ({ picture, ...picture }));
  for (let side = MAX_DRAWN_SIDE; ; side /= 2) {
    let total = 0;
    for (const { picture, width, height } of given) {
      const factor = Math.min(1, side / Math.max(width, height));
      picture.width = Math.max(1, Math.round(factor * width));
      picture.height = Math.max(1, Math.round(factor * height));
      picture.isReduced = factor < 1;
      total += picture.width * picture.height;
    }
    if (total > MAX_DRAWN_PIXELS && side > 1) continue;
    const isReduced = given.some(({ picture }) => picture.isReduced);
    return isReduced ? [`pictures reduced to ${side.toLocaleString('en')} pixels`] : [];
  }
}

/** Statistics of a picture's alpha, in [0, 1]. */
interface PictureAlpha {
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
