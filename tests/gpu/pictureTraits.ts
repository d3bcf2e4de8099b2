import type { PNG } from 'pngjs';

/** The traits of a drawing that are visible from afar, whatever the colours of ink and paper. All are about 0 to 1. */
export interface PictureTraits {
  /** Share of the paper that is covered. */
  ink: number;
  /** Share of the ink that is neither ink nor paper. */
  grey: number;
  /** Length of the edges of the ink per area: large for fine strokes and dots, small for broad ones. */
  fineness: number;
  /** Coherence of neighbouring strokes: 1 for parallel lines, 0 for dots. */
  coherence: number;
  /** Shares of the edges that run in each direction of half a circle; together 1. */
  directions: readonly number[];
}

const DIRECTIONS = 8;
/** Radius, in pixels, over which the directions of edges are compared. */
const NEIGHBOURHOOD = 5;

/** Measures a drawing on blank paper. */
export function pictureTraits({ width, height, data }: PNG): PictureTraits {
  const dark = darkness(data);
  const at = (x: number, y: number): number => dark[y * width + x];
  const [xx, xy, yy] = [0, 1, 2].map(() => new Float64Array(width * height));
  const directions = new Array<number>(DIRECTIONS).fill(0);
  let edges = 0;
  for (let y = 1; y < height - 1; y++) {
    for (let x = 1; x < width - 1; x++) {
      const [dx, dy] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
      const size = Math.hypot(dx, dy);
      if (size === 0) continue;
      const i = y * width + x;
      [xx[i], xy[i], yy[i]] = [dx * dx, dx * dy, dy * dy];
      edges += size;
      const half = ((Math.atan2(dy, dx) / Math.PI + 1) % 1) * DIRECTIONS;
      directions[Math.floor(half) % DIRECTIONS] += size;
    }
  }
  const total = dark.reduce((sum, value) => sum + value, 0);
  const between = dark.reduce((sum, value) => sum + (value > 0.25 && value < 0.75 ? value : 0), 0);
  return {
    ink: total / dark.length,
    grey: between / total,
    fineness: edges / total / 4,
    coherence: coherence(blurred(xx, width), blurred(xy, width), blurred(yy, width)),
    directions: directions.map((sum) => sum / edges),
  };
}

/** The difference of two drawings in each trait. */
export function traitDistances(a: PictureTraits, b: PictureTraits): Record<keyof PictureTraits, number> {
  return {
    ink: Math.abs(a.ink - b.ink),
    grey: Math.abs(a.grey - b.grey),
    fineness: Math.abs(a.fineness - b.fineness),
    coherence: Math.abs(a.coherence - b.coherence),
    directions: a.directions.reduce((sum, share, i) => sum + Math.abs(share - b.directions[i]) / 2, 0),
  };
}

/** Per pixel, 0 for the paper and 1 for the strongest ink of the picture, which may be lighter than its paper. */
function darkness(data: Uint8Array): Float64Array {
  const strength = new Float64Array(data.length / 4);
  const luminance = (i: number): number => 0.2126 * data[4 * i] + 0.7152 * data[4 * i + 1] + 0.0722 * data[4 * i + 2];
  // The corner is blank; a few strongest pixels may be where strokes overlap.
  const paper = luminance(0);
  for (let i = 0; i < strength.length; i++) strength[i] = Math.abs(luminance(i) - paper);
  const ink = strength.toSorted()[Math.floor(0.995 * strength.length)];
  return strength.map((value) => Math.min(1, value / ink));
}

/** The mean over a square around each pixel of some rows and columns. */
function blurred(values: Float64Array, width: number): Float64Array {
  const along = (from: Float64Array, step: number): Float64Array =>
    from.map((_, i) => {
      let sum = 0;
      for (let k = -NEIGHBOURHOOD; k <= NEIGHBOURHOOD; k++) sum += from[i + k * step] ?? 0;
      return sum;
    });
  return along(along(values, 1), width);
}

/** The mean of how far the structure tensors are stretched, each weighted by its edges. */
function coherence(xx: Float64Array, xy: Float64Array, yy: Float64Array): number {
  let stretched = 0;
  let sum = 0;
  for (let i = 0; i < xx.length; i++) {
    stretched += Math.hypot(xx[i] - yy[i], 2 * xy[i]);
    sum += xx[i] + yy[i];
  }
  return stretched / sum;
}
