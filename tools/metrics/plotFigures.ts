/** What a plotter makes of a drawing for one pen: how even its lines are, how much ink lies where, and how often the pen is lifted. */

/** A path, x and y in turn, millimetres. */
type Points = readonly number[];

/** The tones asked for, in cells over the sheet; NaN where there is no surface. */
export interface WantedTones {
  tones: Float32Array;
  columns: number;
  rows: number;
  /** Width of a cell, and the upper left corner of the first, millimetres. */
  size: number;
  left: number;
  top: number;
}

/** Figures of one drawing. */
export interface PlotFigures {
  /** Per family the share of places where one neighbour lies more than 1.5 times as far as the other, and the 75th percentile of that ratio. */
  families: { name: string; uneven: number; p75: number }[];
  /** Mean and signed difference from the tone asked for, over blocks of 13 mm. */
  toneError: number;
  toneBias: number;
  lifts: number;
  /** The share of strokes shorter than 1.5 mm, and the median length, millimetres. */
  short: number;
  median: number;
  /** The share of the inked area with three passes or more, outlines and dots included. */
  soaked: number;
  /** Metres. */
  ink: number;
}

/** Sampled places of a family, and the farthest neighbour, millimetres. */
const PLACES = 4000;
const FARTHEST = 2.5;
const LEAST_PLACES = 20;
/** Neighbours run the same way: cosine. */
const ALIKE = 0.9;
/** Neighbours on the line itself begin here, millimetres. */
const ITSELF = 0.02;
const UNEVEN = 1.5;
const SHORT = 1.5;
const BLOCK = 13;
/** Blocks count with tones in between, and with so much surface. */
const TONES = [0.1, 0.8] as const;
const COVERED = 0.5;
const SAMPLES_PER_MILLIMETRE = 20;
const SOAKED = 3;

const sum = (numbers: readonly number[]): number => numbers.reduce((total, one) => total + one, 0);
const at = (sorted: readonly number[], share: number): number => sorted[Math.floor(share * (sorted.length - 1))];

function lengthOf(points: Points): number {
  let length = 0;
  for (let o = 2; o < points.length; o += 2)
    length += Math.hypot(points[o] - points[o - 2], points[o + 1] - points[o - 1]);
  return length;
}

/**
 * Measures the hatching of a drawing.
 *
 * @param layers paths of the hatching by the names of their layers
 * @param others paths that count for passes alone, such as outlines
 * @param pen its width, millimetres
 */
export function plotFigures(
  layers: ReadonlyMap<string, readonly Points[]>,
  others: readonly Points[],
  pen: number,
  sheet: readonly [width: number, height: number],
  wanted: WantedTones,
): PlotFigures {
  const paths = [...layers.values()].flat();
  const lengths = paths.map(lengthOf).sort((a, b) => a - b);
  const passes = passesOf(paths, pen, sheet);
  const { counts } = passesOf([...paths, ...others], pen, sheet);
  const inked = counts.reduce((total, count) => total + Number(count > 0), 0);
  const soaked = counts.reduce((total, count) => total + Number(count >= SOAKED), 0);
  const errors = toneErrors(passes, wanted);
  return {
    families: [...layers].flatMap(([name, own]) => {
      const ratios = gapRatios(own).sort((a, b) => a - b);
      if (ratios.length < LEAST_PLACES) return [];
      return [{ name, uneven: ratios.filter((ratio) => ratio > UNEVEN).length / ratios.length, p75: at(ratios, 0.75) }];
    }),
    toneError: sum(errors.map(Math.abs)) / errors.length,
    toneBias: sum(errors) / errors.length,
    lifts: paths.length,
    short: lengths.filter((length) => length < SHORT).length / lengths.length,
    median: at(lengths, 0.5),
    soaked: soaked / inked,
    ink: sum(lengths) / 1000,
  };
}

/** A straight piece of a path. */
interface Piece {
  path: number;
  x: number;
  y: number;
  dx: number;
  dy: number;
  length: number;
}

/** The ratios of the wider gap to the narrower one at places along the lines of a family that have neighbours on both sides. */
function gapRatios(paths: readonly Points[]): number[] {
  const pieces: Piece[] = [];
  for (const [path, points] of paths.entries()) {
    for (let o = 2; o < points.length; o += 2) {
      const [x, y] = [points[o - 2], points[o - 1]];
      const [dx, dy] = [points[o] - x, points[o + 1] - y];
      const length = Math.hypot(dx, dy);
      if (length > 0) pieces.push({ path, x, y, dx: dx / length, dy: dy / length, length });
    }
  }
  const cells = new Map<string, Piece[]>();
  for (const piece of pieces) {
    const steps = Math.ceil(piece.length / (0.5 * FARTHEST));
    const known = new Set<string>();
    for (let k = 0; k <= steps; k++) {
      const way = (k / steps) * piece.length;
      known.add(cellOf(piece.x + way * piece.dx, piece.y + way * piece.dy));
    }
    for (const cell of known) {
      const list = cells.get(cell);
      if (list) list.push(piece);
      else cells.set(cell, [piece]);
    }
  }
  const ratios: number[] = [];
  const every = sum(pieces.map(({ length }) => length)) / PLACES;
  let next = 0.5 * every;
  for (const piece of pieces) {
    for (; next < piece.length; next += every) {
      const [one, other] = [1, -1].map((side) => gapBeside(piece, next, side, cells));
      if (one < Infinity && other < Infinity) ratios.push(Math.max(one, other) / Math.max(Math.min(one, other), 1e-3));
    }
    next -= piece.length;
  }
  return ratios;
}

const cellOf = (x: number, y: number): string => `${Math.floor(x / FARTHEST)} ${Math.floor(y / FARTHEST)}`;

/** The distance of the nearest parallel line to one side of a place of a piece; Infinity for none. */
function gapBeside(piece: Piece, way: number, side: number, cells: ReadonlyMap<string, readonly Piece[]>): number {
  const [x, y] = [piece.x + way * piece.dx, piece.y + way * piece.dy];
  const [nx, ny] = [-side * piece.dy, side * piece.dx];
  let least = Infinity;
  for (const across of [-1, 0, 1]) {
    for (const down of [-1, 0, 1]) {
      for (const other of cells.get(cellOf(x + across * FARTHEST, y + down * FARTHEST)) ?? []) {
        if (other.path === piece.path) continue;
        const turn = other.dx * ny - other.dy * nx;
        if (Math.abs(other.dx * piece.dx + other.dy * piece.dy) < ALIKE) continue;
        // Where the ray and the other line cross.
        const [ox, oy] = [other.x - x, other.y - y];
        const gap = (other.dx * oy - other.dy * ox) / turn;
        const along = (nx * oy - ny * ox) / turn;
        if (gap > ITSELF && gap < Math.min(least, FARTHEST) && along >= 0 && along <= other.length) least = gap;
      }
    }
  }
  return least;
}

/** How many paths cover each sample of the sheet. */
interface Passes {
  counts: Uint8Array;
  columns: number;
}

function passesOf(paths: readonly Points[], pen: number, [width, height]: readonly [number, number]): Passes {
  const [columns, rows] = [width, height].map((side) => Math.ceil(side * SAMPLES_PER_MILLIMETRE));
  const counts = new Uint8Array(columns * rows);
  const last = new Int32Array(columns * rows).fill(-1);
  const radius = 0.5 * pen;
  const sampleOf = (value: number): number => value * SAMPLES_PER_MILLIMETRE - 0.5;
  for (const [path, points] of paths.entries()) {
    for (let o = 2; o < points.length; o += 2) {
      const [x, y, toX, toY] = [points[o - 2], points[o - 1], points[o], points[o + 1]];
      const [dx, dy] = [toX - x, toY - y];
      const square = dx * dx + dy * dy;
      const top = Math.max(Math.ceil(sampleOf(Math.min(y, toY) - radius)), 0);
      const bottom = Math.min(Math.floor(sampleOf(Math.max(y, toY) + radius)), rows - 1);
      const left = Math.max(Math.ceil(sampleOf(Math.min(x, toX) - radius)), 0);
      const right = Math.min(Math.floor(sampleOf(Math.max(x, toX) + radius)), columns - 1);
      for (let row = top; row <= bottom; row++) {
        for (let column = left; column <= right; column++) {
          const i = row * columns + column;
          if (last[i] === path) continue;
          const [px, py] = [(column + 0.5) / SAMPLES_PER_MILLIMETRE - x, (row + 0.5) / SAMPLES_PER_MILLIMETRE - y];
          const t = square > 0 ? Math.min(Math.max((px * dx + py * dy) / square, 0), 1) : 0;
          if (Math.hypot(px - t * dx, py - t * dy) > radius) continue;
          last[i] = path;
          counts[i] = Math.min(counts[i] + 1, 255);
        }
      }
    }
  }
  return { counts, columns };
}

/** The share of ink minus the tone asked for, per block. */
function toneErrors({ counts, columns }: Passes, wanted: WantedTones): number[] {
  const { tones, size, left, top } = wanted;
  const side = Math.round(BLOCK / size);
  const samples = Math.round(size * SAMPLES_PER_MILLIMETRE);
  const inkOf = (column: number, row: number): number => {
    const [x, y] = [left + column * size, top + row * size].map((value) => Math.floor(value * SAMPLES_PER_MILLIMETRE));
    let ink = 0;
    for (let j = 0; j < samples; j++)
      for (let i = 0; i < samples; i++) ink += Number(counts[(y + j) * columns + x + i] > 0);
    return ink / samples ** 2;
  };
  const errors: number[] = [];
  for (let row = 0; row < wanted.rows; row += side) {
    for (let column = 0; column < wanted.columns; column += side) {
      let [asked, got, count] = [0, 0, 0];
      for (let y = row; y < Math.min(row + side, wanted.rows); y++) {
        for (let x = column; x < Math.min(column + side, wanted.columns); x++) {
          const tone = tones[y * wanted.columns + x];
          if (Number.isNaN(tone)) continue;
          asked += tone;
          got += inkOf(x, y);
          count++;
        }
      }
      const tone = asked / count;
      if (count >= COVERED * side * side && tone >= TONES[0] && tone <= TONES[1]) errors.push(got / count - tone);
    }
  }
  return errors;
}
