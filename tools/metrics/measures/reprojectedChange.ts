import { FlipCount } from './normalisedFlips.js';
import { isInk, type SurfaceImage } from './SurfaceImage.js';

/** A picture with the point of the object that each pixel shows. */
export interface LocatedImage extends SurfaceImage {
  /** Per pixel: xyz on the object, then the cosine between normal and line of sight. */
  readonly places: Float32Array;
  /** Object space to clip space, column-major, for the camera of this picture. Rows of pixels run up, as in GL. */
  readonly objectToClip: ArrayLike<number>;
}

/** Surfaces with a smaller cosine to the line of sight are left out: a pixel covers a long strip there. */
const LEAST_FACING = 0.3;
/** A point counts as hidden if the pixel where it should appear shows a point farther away than this, in pixels. */
const SAME_PLACE_PIXELS = 4;

export interface FrameChange {
  /** Normalised: 0 where nothing changes, 1 for unrelated frames. */
  flips: number;
  /** Mean difference of luminance: for soft edges, whose flips say only when a line has become half dark. */
  luminance: number;
}

/**
 * M6: what changes between two frames of a moving camera. Each point seen in the first frame is looked up in the second by
 * bilinear interpolation; points that are hidden there are left out.
 */
export function reprojectedChange(before: LocatedImage, after: LocatedImage): FrameChange {
  const { width, height, places } = before;
  const m = after.objectToClip;
  const count = new FlipCount();
  let difference = 0;
  let points = 0;
  for (let i = 0; i < before.luminance.length; i++) {
    if (before.surface[i] === 0 || places[4 * i + 3] < LEAST_FACING) continue;
    const [x, y, z] = [places[4 * i], places[4 * i + 1], places[4 * i + 2]];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    const column = ((m[0] * x + m[4] * y + m[8] * z + m[12]) / w / 2 + 0.5) * width - 0.5;
    const row = ((m[1] * x + m[5] * y + m[9] * z + m[13]) / w / 2 + 0.5) * height - 0.5;
    const [left, bottom] = [Math.floor(column), Math.floor(row)];
    if (!(left >= 0 && bottom >= 0 && left + 1 < width && bottom + 1 < height)) continue;
    const corners = [0, 1, width, width + 1].map((step) => bottom * width + left + step);
    if (corners.some((corner) => after.surface[corner] === 0)) continue;

    // Object units to a pixel at this depth: the first two rows of the matrix hold pixels per unit, times w.
    const pixelsPerUnit = (Math.hypot(m[1], m[5], m[9]) * height) / 2 / w;
    const nearest = Math.round(row) * width + Math.round(column);
    const away = Math.hypot(
      after.places[4 * nearest] - x,
      after.places[4 * nearest + 1] - y,
      after.places[4 * nearest + 2] - z,
    );
    if (away * pixelsPerUnit > SAME_PLACE_PIXELS) continue;

    const [u, v] = [column - left, row - bottom];
    const [a, b, c, d] = corners.map((corner) => after.luminance[corner]) as [number, number, number, number];
    const shown = (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d);
    count.add(isInk(before.luminance[i]), isInk(shown));
    difference += Math.abs(before.luminance[i] - shown);
    points++;
  }
  return { flips: count.normalised(), luminance: difference / points };
}

/** The largest value over the median in the frames of a steady camera move. 1 is perfectly even. */
export function poppingIndex(changes: readonly number[]): number {
  const sorted = changes.toSorted((a, b) => a - b);
  const middle = sorted.length >> 1;
  const median = sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  return sorted.at(-1)! / median;
}
