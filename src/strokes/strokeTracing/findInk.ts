import { chunkPhase } from '../../mesh/phases.js';
import { gridValue, otsuThreshold, type PaperGrid } from './PaperGrid.js';
import type { GreyImage } from './ScannedImage.js';

/** Least depth of an ink pixel, as a share of the depth of ink. */
const INK_SHARE = 0.45;
/** Steps of the histograms of depth. */
const BINS = 256;

/** The ink of a picture. */
export interface Ink {
  width: number;
  height: number;
  /** How much darker each pixel is than its paper, as a share of the paper's brightness; noise makes it negative too. */
  depths: Float32Array;
  /** The depth of a pixel entirely covered by ink. */
  fullDepth: number;
  /** 1 for ink, 0 for paper. The outermost pixels are paper. */
  mask: Uint8Array;
}

/** Separates ink from paper: a pixel is ink if it is darker than the local paper by about half the depth of the surrounding ink. */
export function* findInk(image: GreyImage, grid: PaperGrid): Generator<number, Ink, void> {
  const { width, height } = image;
  const raw = new Float32Array(width * height);
  yield* chunkPhase(raw.length, 0, 0.4, (start, end) => measureDepths(image, grid, raw, start, end));
  const softened = new Float32Array(raw.length);
  yield* chunkPhase(raw.length, 0.4, 0.6, (start, end) => soften(raw, width, height, softened, start, end));
  const mask = new Uint8Array(raw.length);
  const histogram = new Uint32Array(BINS);
  yield* chunkPhase(raw.length, 0.6, 0.7, (start, end) => countDepths(softened, mask, 0, histogram, start, end));
  const first = ((otsuThreshold(histogram) ?? 0) + 1) / BINS;
  yield* chunkPhase(raw.length, 0.7, 0.8, (start, end) =>
    markInk(softened, width, height, mask, () => first, start, end),
  );
  histogram.fill(0);
  yield* chunkPhase(raw.length, 0.8, 0.9, (start, end) => countDepths(softened, mask, 1, histogram, start, end));
  // Most ink lies near the edges of strokes, where blur makes it paler.
  const fullDepth = quantile(histogram, 0.8);
  const threshold = (x: number, y: number): number =>
    INK_SHARE * Math.min(fullDepth, 1.1 * gridValue(grid, grid.depth, x, y));
  yield* chunkPhase(raw.length, 0.9, 1, (start, end) => markInk(softened, width, height, mask, threshold, start, end));
  return { width, height, depths: raw, fullDepth, mask };
}

function measureDepths(image: GreyImage, grid: PaperGrid, depths: Float32Array, start: number, end: number): void {
  const { width, values } = image;
  for (let i = start; i < end; i++) {
    depths[i] = 1 - values[i] / gridValue(grid, grid.paper, i % width, Math.floor(i / width));
  }
}

/** A binomial filter of three by three pixels against noise. */
function soften(
  values: Float32Array,
  width: number,
  height: number,
  result: Float32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const x = i % width;
    const left = x > 0 ? -1 : 0;
    const right = x < width - 1 ? 1 : 0;
    const up = i >= width ? -width : 0;
    const down = i < width * (height - 1) ? width : 0;
    result[i] =
      (4 * values[i] +
        2 * (values[i + left] + values[i + right] + values[i + up] + values[i + down]) +
        values[i + up + left] +
        values[i + up + right] +
        values[i + down + left] +
        values[i + down + right]) /
      16;
  }
}

function markInk(
  depths: Float32Array,
  width: number,
  height: number,
  mask: Uint8Array,
  threshold: (x: number, y: number) => number,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const x = i % width;
    const y = Math.floor(i / width);
    const isInner = x > 0 && y > 0 && x < width - 1 && y < height - 1;
    mask[i] = isInner && depths[i] > threshold(x, y) ? 1 : 0;
  }
}

/** Counts the depths of the pixels whose mask is `kind`. */
function countDepths(
  depths: Float32Array,
  mask: Uint8Array,
  kind: number,
  histogram: Uint32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) if (mask[i] === kind) histogram[binOf(depths[i])]++;
}

const binOf = (depth: number): number => Math.min(BINS - 1, Math.max(0, Math.floor(BINS * depth)));

/**
 * The depth of full ink: that along the middle of the widest strokes, beyond the reach of blur.
 *
 * @param lines the pixels along the middle of strokes
 * @param distances the distance of every pixel to paper
 */
export function depthOfLines({ depths, fullDepth }: Ink, lines: Int32Array, distances: Float32Array): number {
  if (lines.length === 0) return fullDepth;
  const wide = Float32Array.from(lines, (pixel) => distances[pixel]).sort()[Math.floor(0.75 * lines.length)];
  const histogram = new Uint32Array(BINS);
  for (const pixel of lines) if (distances[pixel] >= wide) histogram[binOf(depths[pixel])]++;
  return quantile(histogram, 0.5);
}

function quantile(histogram: Uint32Array, share: number): number {
  const wanted = share * histogram.reduce((sum, count) => sum + count, 0);
  let sum = 0;
  for (let bin = 0; bin < histogram.length; bin++) {
    sum += histogram[bin];
    if (sum >= wanted) return (bin + 0.5) / BINS;
  }
  return 1;
}
