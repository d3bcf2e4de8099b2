import { forEachChunk } from '../../mesh/phases.js';
import type { ScannedImage } from './ScannedImage.js';

/** The brightness of every pixel, from 0 (black) to 255. */
export interface GreyImage {
  width: number;
  height: number;
  values: Float32Array;
}

/** Larger pictures are reduced before tracing: strokes stay wide enough, and the work is bounded. */
const MOST_TRACED_PIXELS = 4_000_000;

/** The number of pixels per side that become one traced pixel. */
export const reductionOf = ({ width, height }: ScannedImage): number =>
  Math.max(1, Math.ceil(Math.sqrt((width * height) / MOST_TRACED_PIXELS)));

/** Reads the brightness of a picture, and averages it over blocks if it is large. Yields progress in [0, 1]. */
export function* readGrey(image: ScannedImage): Generator<number, GreyImage, void> {
  const block = reductionOf(image);
  const width = Math.floor(image.width / block);
  const height = Math.floor(image.height / block);
  const values = new Float32Array(width * height);
  yield* forEachChunk(values.length, (start, end) => averageBlocks(image, block, width, values, start, end));
  return { width, height, values };
}

function averageBlocks(
  image: ScannedImage,
  block: number,
  width: number,
  values: Float32Array,
  start: number,
  end: number,
): void {
  const isGrey = image.data.length === image.width * image.height;
  for (let i = start; i < end; i++) {
    const left = block * (i % width);
    const top = block * Math.floor(i / width);
    let sum = 0;
    for (let y = top; y < top + block; y++) {
      for (let x = left; x < left + block; x++) {
        const pixel = y * image.width + x;
        sum += isGrey ? image.data[pixel] : brightnessOnWhite(image.data, 4 * pixel);
      }
    }
    values[i] = sum / (block * block);
  }
}

function brightnessOnWhite(data: Uint8Array | Uint8ClampedArray, at: number): number {
  const grey = 0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2];
  return 255 + ((grey - 255) * data[at + 3]) / 255;
}
