import { forEachChunk } from '../../mesh/phases.js';
import type { GreyImage } from './ScannedImage.js';

/** Approximate number of cells. */
const CELLS = 900;
const LEAST_CELL = 16;
/** Ink is darker than its paper by at least this share. */
const LEAST_DEPTH = 0.12;
/** Least distance of ink from paper in deviations of the paper: a ramp of light has 3.5, noise 2.7. */
const LEAST_SEPARATION = 4.5;

/** The brightness of the paper and the depth of the ink in the cells of a grid, which compensates uneven light. */
export interface PaperGrid {
  /** Pixels per side of a cell. */
  cell: number;
  columns: number;
  rows: number;
  /** The brightness of the paper in each cell. */
  paper: Float32Array;
  /** How much darker the ink is than the paper in each cell, as a share of the paper's brightness. */
  depth: Float32Array;
}

/** The two classes of pixels in a window. */
interface Classes {
  paper: number;
  ink: number;
}

/**
 * Finds the local brightness of the paper. Around each cell the pixels are separated into paper and ink (Otsu 1979); a cell whose
 * surroundings hold only one of them takes the other from nearby cells.
 *
 * @returns undefined if no cell holds both paper and ink; yields progress in [0, 1]
 */
export function* findPaper(image: GreyImage): Generator<number, PaperGrid | undefined, void> {
  const { width, height } = image;
  const cell = Math.max(LEAST_CELL, Math.ceil(Math.sqrt((width * height) / CELLS)));
  const columns = Math.ceil(width / cell);
  const rows = Math.ceil(height / cell);
  const histograms = new Uint32Array(256 * columns * rows);
  yield* forEachChunk(image.values.length, (start, end) => countValues(image, cell, columns, histograms, start, end));
  const cells = Array.from({ length: columns * rows }, (_, i) =>
    windowOf(histograms, columns, rows, i % columns, Math.floor(i / columns)),
  );
  const classes = cells.map(partIntoClasses);
  if (classes.every((found) => !found)) return undefined;
  const means = cells.map((values) => meanOf(values, 0, 255));
  const all = spread(classes, means, columns);
  const paper = Float32Array.from(all, (found) => Math.max(1, found.paper));
  const depth = Float32Array.from(all, (found) => 1 - found.ink / Math.max(1, found.paper));
  return { cell, columns, rows, paper: smoothed(paper, columns, rows), depth: smoothed(depth, columns, rows) };
}

/** The value of a grid at a pixel, bilinear between the centres of cells. */
export function gridValue({ cell, columns, rows }: PaperGrid, values: Float32Array, x: number, y: number): number {
  const column = Math.min(columns - 1, Math.max(0, (x + 0.5) / cell - 0.5));
  const row = Math.min(rows - 1, Math.max(0, (y + 0.5) / cell - 0.5));
  const left = Math.floor(column);
  const top = Math.floor(row);
  const right = Math.min(columns - 1, left + 1);
  const bottom = Math.min(rows - 1, top + 1);
  const across = column - left;
  const upper = values[top * columns + left] * (1 - across) + values[top * columns + right] * across;
  const lower = values[bottom * columns + left] * (1 - across) + values[bottom * columns + right] * across;
  return upper + (lower - upper) * (row - top);
}

function countValues(
  { width, values }: GreyImage,
  cell: number,
  columns: number,
  histograms: Uint32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const row = Math.floor(Math.floor(i / width) / cell);
    const column = Math.floor((i % width) / cell);
    histograms[256 * (row * columns + column) + Math.round(values[i])]++;
  }
}

/** The histogram of a cell and the eight around it. */
function windowOf(all: Uint32Array, columns: number, rows: number, column: number, row: number): Uint32Array {
  const sum = new Uint32Array(256);
  for (let y = Math.max(0, row - 1); y <= Math.min(rows - 1, row + 1); y++) {
    for (let x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
      const start = 256 * (y * columns + x);
      for (let value = 0; value < 256; value++) sum[value] += all[start + value];
    }
  }
  return sum;
}

function partIntoClasses(histogram: Uint32Array): Classes | undefined {
  const cut = otsuThreshold(histogram);
  if (cut === undefined) return undefined;
  const ink = meanOf(histogram, 0, cut);
  const paper = meanOf(histogram, cut + 1, 255);
  let squares = 0;
  let count = 0;
  for (let value = cut + 1; value < 256; value++) {
    squares += histogram[value] * (value - paper) ** 2;
    count += histogram[value];
  }
  const separation = paper - ink;
  if (separation < LEAST_DEPTH * paper || separation < LEAST_SEPARATION * Math.sqrt(squares / count)) return undefined;
  return { paper, ink };
}

/** The last value of the darker class, which maximises the variance between the classes; undefined for a single value. */
export function otsuThreshold(histogram: ArrayLike<number>): number | undefined {
  let total = 0;
  let sum = 0;
  for (let value = 0; value < histogram.length; value++) {
    total += histogram[value];
    sum += value * histogram[value];
  }
  let below = 0;
  let sumBelow = 0;
  let best = 0;
  let cut: number | undefined;
  for (let value = 0; value < histogram.length - 1; value++) {
    below += histogram[value];
    sumBelow += value * histogram[value];
    if (below === 0 || below === total) continue;
    const difference = sumBelow / below - (sum - sumBelow) / (total - below);
    const between = below * (total - below) * difference * difference;
    if (between <= best) continue;
    best = between;
    cut = value;
  }
  return cut;
}

function meanOf(histogram: Uint32Array, from: number, to: number): number {
  let count = 0;
  let sum = 0;
  for (let value = from; value <= to; value++) {
    count += histogram[value];
    sum += value * histogram[value];
  }
  return sum / count;
}

/**
 * Gives the cells that hold only paper or only ink the other from those beside them, from cell to cell, so that paper which darkens slowly
 * stays paper.
 *
 * @param means the mean brightness of each cell
 */
function spread(classes: readonly (Classes | undefined)[], means: readonly number[], columns: number): Classes[] {
  const all = [...classes];
  const rows = all.length / columns;
  for (;;) {
    const ring = all.flatMap((found, i): { i: number; found: Classes }[] => {
      const beside = found ? [] : besideOf(all, i, columns, rows);
      if (beside.length === 0) return [];
      const paper = beside.reduce((sum, one) => sum + one.paper, 0) / beside.length;
      const ink = beside.reduce((sum, one) => sum + one.ink, 0) / beside.length;
      const isPaper = means[i] > 0.5 * (paper + ink);
      const scale = isPaper ? means[i] / Math.max(1, paper) : 1;
      return [{ i, found: { paper: scale * paper, ink: scale * ink } }];
    });
    if (ring.length === 0) return all as Classes[];
    for (const { i, found } of ring) all[i] = found;
  }
}

/** What is known of the eight cells around one. */
function besideOf(all: readonly (Classes | undefined)[], i: number, columns: number, rows: number): Classes[] {
  const [column, row] = [i % columns, Math.floor(i / columns)];
  const beside: Classes[] = [];
  for (let y = Math.max(0, row - 1); y <= Math.min(rows - 1, row + 1); y++) {
    for (let x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
      const found = all[y * columns + x];
      if (found) beside.push(found);
    }
  }
  return beside;
}

function smoothed(values: Float32Array, columns: number, rows: number): Float32Array {
  return values.map((_, i) => {
    let weights = 0;
    let sum = 0;
    for (let down = -1; down <= 1; down++) {
      for (let across = -1; across <= 1; across++) {
        const x = (i % columns) + across;
        const y = Math.floor(i / columns) + down;
        if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
        const weight = (2 - Math.abs(across)) * (2 - Math.abs(down));
        weights += weight;
        sum += weight * values[y * columns + x];
      }
    }
    return sum / weights;
  });
}
