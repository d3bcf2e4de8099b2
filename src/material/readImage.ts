import { DataUtils, HalfFloatType, NearestFilter, SRGBColorSpace, type Texture } from 'three';

/** The greatest number of pixels per side that is read; larger images are scaled down. */
const MAX_PIXELS = 2048;

/** The pixels of a texture. */
export interface TextureImage {
  width: number;
  height: number;
  /** Red, green, blue and alpha of each pixel in linear light; the first row is at v = 0. */
  data: Float32Array;
}

/** Reads the pixels of a texture in linear light, the first row at v = 0; null if this thread cannot read them. */
export function readImage(texture: Texture): TextureImage | null {
  const pixels = pixelsOf(texture.image);
  if (!pixels) return null;
  const { width, height, data } = pixels;
  const channels = data.length / (width * height);
  if (!(channels >= 1 && Number.isInteger(channels))) return null;
  const decode = decoderOf(texture, data);
  const step = Math.ceil(Math.max(width, height) / MAX_PIXELS);
  const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
  const image = new Float32Array(4 * columns * rows);
  const isFlipped = texture.flipY && !isBitmap(texture.image);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const o = 4 * (row * columns + column);
      const [endX, endY] = [Math.min(width, step * (column + 1)), Math.min(height, step * (row + 1))];
      const count = (endX - step * column) * (endY - step * row);
      for (let y = step * row; y < endY; y++) {
        const source = (isFlipped ? height - 1 - y : y) * width;
        for (let x = step * column; x < endX; x++) {
          for (let k = 0; k < 4; k++) {
            const stored = k < channels ? decode(channels * (source + x) + k, k) : Number(k === 3);
            image[o + k] += stored / count;
          }
        }
      }
    }
  }
  return { width: columns, height: rows, data: image };
}

/** Whether a magnified texture shows the edges of its pixels. */
export const isSharp = ({ magFilter }: Texture): boolean => magFilter === NearestFilter;

/** Returns a function that reads channel k of a pixel as a number. sRGB colours are converted to linear light; alpha is not. */
export function decoderOf({ type, colorSpace }: Texture, data: ArrayLike<number>): (i: number, k: number) => number {
  const most =
    data instanceof Uint8Array || data instanceof Uint8ClampedArray ? 255 : data instanceof Uint16Array ? 65535 : 1;
  const isHalf = type === HalfFloatType;
  const isEncoded = colorSpace === SRGBColorSpace;
  return (i, k) => {
    const stored = isHalf ? DataUtils.fromHalfFloat(data[i]) : data[i] / most;
    if (!isEncoded || k === 3) return stored;
    return stored < 0.04045 ? stored / 12.92 : ((stored + 0.055) / 1.055) ** 2.4;
  };
}

interface Pixels {
  width: number;
  height: number;
  data: ArrayLike<number>;
}

/** Whether an image is an ImageBitmap, which WebGL never flips. */
const isBitmap = (image: unknown): boolean => typeof ImageBitmap !== 'undefined' && image instanceof ImageBitmap;

function pixelsOf(given: unknown): Pixels | null {
  const image = given as (Partial<Pixels> & { naturalWidth?: number; videoWidth?: number }) | null;
  if (!image) return null;
  if (image.data && ArrayBuffer.isView(image.data) && image.width! > 0 && image.height! > 0) return image as Pixels;
  const width = image.naturalWidth ?? image.videoWidth ?? image.width ?? 0;
  if (typeof OffscreenCanvas === 'undefined' || !(width > 0)) return null;
  const source = image as unknown as CanvasImageSource;
  const height = image.naturalWidth ? (image as HTMLImageElement).naturalHeight : image.height!;
  const scale = Math.min(1, MAX_PIXELS / Math.max(width, height));
  const size = [Math.max(1, Math.round(scale * width)), Math.max(1, Math.round(scale * height))] as const;
  try {
    const context = new OffscreenCanvas(...size).getContext('2d')!;
    context.drawImage(source, 0, 0, ...size);
    return context.getImageData(0, 0, ...size);
  } catch {
    // The image is of another origin, or an ImageBitmap that was closed.
    return null;
  }
}
