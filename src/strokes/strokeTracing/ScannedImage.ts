import { forEachChunk } from '../../mesh/phases.js';

/** A picture of a swatch: a photograph or a scan of strokes on paper, darker than the paper. */
export interface ScannedImage {
  /** Pixels per row. */
  width: number;
  /** Rows. */
  height: number;
  /** The rows from top to bottom: one byte per pixel (grey, 255 = white) or four (RGBA, as in `ImageData`; lies on white). */
  data: Uint8Array | Uint8ClampedArray;
}

/** Least number of pixels along each side. */
const LEAST_SIDE = 16;
/** Largest number of pixels. */
const MOST_PIXELS = 16_000_000;

/**
 * Checks a picture.
 *
 * @throws TypeError or RangeError that names the fault and the remedy
 */
export function checkScannedImage(image: ScannedImage): void {
  if (typeof image !== 'object' || image === null) {
    throw new TypeError(`traceStrokes: expected a picture { width, height, data }, but got ${String(image)}.`);
  }
  const { width, height, data } = image;
  for (const [name, side] of Object.entries({ width, height })) {
    if (!Number.isInteger(side) || side < LEAST_SIDE) {
      const told = typeof side === 'number' ? side : typeof side;
      throw new RangeError(
        `traceStrokes: the picture's ${name} is ${told}, but must be a whole number of at least ${LEAST_SIDE} pixels.`,
      );
    }
  }
  if (width * height > MOST_PIXELS) {
    throw new RangeError(
      `traceStrokes: the picture has ${width} × ${height} pixels, but at most 16 million are traced; scale it down first.`,
    );
  }
  if (!(data instanceof Uint8Array || data instanceof Uint8ClampedArray)) {
    throw new TypeError(
      'traceStrokes: the data of the picture must be a Uint8Array or Uint8ClampedArray, as in ImageData.',
    );
  }
  const pixels = width * height;
  if (data.length !== pixels && data.length !== 4 * pixels) {
    throw new RangeError(
      `traceStrokes: the picture has ${data.length} bytes, but ${width} × ${height} pixels need ${pixels} (grey) or ${4 * pixels} (RGBA).`,
    );
  }
}

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
