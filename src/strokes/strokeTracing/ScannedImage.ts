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
