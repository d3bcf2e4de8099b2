import type { CarriedRun } from './carryLines.js';
import { LineGrower, STEP } from './LineGrower.js';
import type { LineLaws } from './LineLaws.js';
import { LinePoints, UNNUMBERED } from './LinePoints.js';
import { SeedHeap } from './SeedHeap.js';

/** Lengths of lines in widths of the pen: the least, that in the darks and its distances between lines, and that of lines that begin at outlines. */
const LEAST = 10;
const LEAST_IN_DARK = 5;
const DISTANCES = 5;
const LEAST_FROM_OUTLINE = 10 / 3;
const LEAST_ACROSS = 8 / 3;
/** An end so near to an outline lies at it, in widths of the pen. */
const AT_OUTLINE = 5 / 3;
/** Grids of seeds, in widths of the pen, with the length that their lines are expected to have and the least that counts. */
const GRIDS = [
  { apart: 10, expected: 130, least: 13 },
  { apart: 2, expected: 20, least: LEAST },
];
/** Seeds beside a line: their distance along it is a share of its length, within bounds in widths of the pen. */
const SEEDS_ALONG = 1 / 12;
const SEEDS_APART = [5, 13] as const;
/** A line is placed if it is at least this share of the next one's length and of what was expected. */
const LONG_ENOUGH = 0.9;
/** A line beside another may be a little longer. */
const LONGER = 1.05;
const GOLDEN = 0.6180339887;
/** The least number of points of a line that is carried from frame to frame; and what is left of one is carried if it is most of it, or so long, in widths of the pen. */
const LEAST_CARRIED = 3;
const MOST_OF_LINE = 0.6;
const LEAST_PART = 40;
/** Seeds per step. */
const CHUNK = 8;

/**
 * Places lines of a set, longest first, at the distances that the tone asks for (Mebarki and others, 2005). Yields its progress.
 *
 * @param carried lines of the frame before, which come first as far as they fit
 */
export function* placeLines(laws: LineLaws, carried: readonly CarriedRun[] = []): Generator<number, LinePoints, void> {
  const placer = new LinePlacer(laws);
  yield* placer.carry(carried);
  for (const [i, grid] of GRIDS.entries()) {
    placer.sow(grid.apart * laws.pen, grid.expected * laws.pen);
    for (const _ of placer.grow(grid.least * laws.pen)) yield (i + 1) / (GRIDS.length + 1);
  }
  return placer.points;
}

/** The least length of a line by its ends and the distance to others in its middle, millimetres. */
export function leastLength(
  laws: LineLaws,
  points: { x: Float64Array; y: Float64Array; apart: Float64Array },
  first: number,
  end: number,
): number {
  const { pen, fields } = laws;
  const isAtOutline = (i: number): number => Number(fields.sheet.awayAt(points.x[i], points.y[i]) < AT_OUTLINE * pen);
  const ends = isAtOutline(first) + isAtOutline(end - 1);
  if (ends > 0) return pen * (ends === 2 ? LEAST_ACROSS : LEAST_FROM_OUTLINE);
  const middle = points.apart[(first + end) >> 1];
  return Math.min(LEAST * pen, Math.max(LEAST_IN_DARK * pen, DISTANCES * middle));
}

/** The parts of lines of the frame before that fit beside each other. Yields now and then. */
function* fittingParts(runs: readonly CarriedRun[], laws: LineLaws): Generator<number, LinePoints, void> {
  const parts = new LinePoints(laws.fields.sheet, LEAST_FROM_OUTLINE * laws.pen);
  const grower = new LineGrower(laws, parts);
  const { line } = grower;
  for (const run of runs) {
    yield 0;
    let { id } = run;
    for (let i = 0; i < run.x.length; ) {
      i = grower.take(run, i);
      const isWhole = line.count >= Math.max(MOST_OF_LINE * run.whole, LEAST_CARRIED);
      if (!isWhole && line.count * STEP < LEAST_PART) continue;
      parts.pushLine(line, run.lot, id);
      // Another part of a line is a line of its own.
      id = UNNUMBERED;
    }
  }
  return parts;
}

class LinePlacer {
  readonly points: LinePoints;
  private readonly heap = new SeedHeap();
  private readonly grower: LineGrower;
  private number = 0;

  constructor(private readonly laws: LineLaws) {
    this.points = new LinePoints(laws.fields.sheet, LEAST_FROM_OUTLINE * laws.pen);
    this.grower = new LineGrower(laws, this.points);
  }

  /** Sows seeds on a grid. */
  sow(apart: number, expected: number): void {
    const { laws } = this;
    const { fields, set } = laws;
    for (let row = 0, y = 0.5 * apart; y < fields.sheet.height; row++, y += apart) {
      for (let x = (row % 2 === 0 ? 0.25 : 0.75) * apart; x < fields.sheet.width; x += apart) {
        if (fields.sheet.triangleAt(x, y) < 0) continue;
        fields.look(set, x, y);
        if (fields.tone > laws.lightest(0)) this.push(x, y, expected);
      }
    }
  }

  /** Places the parts of lines of the frame before that fit, and goes on from their ends. Yields now and then. */
  *carry(runs: readonly CarriedRun[]): Generator<number, void, void> {
    const { grower, laws } = this;
    const fitting = yield* fittingParts(runs, laws);
    for (let number = 0; number < fitting.lines; number++) {
      if (number % CHUNK === 0) yield 0;
      grower.extend(fitting, number);
      const { line } = grower;
      const length = (line.count - 1) * STEP * laws.pen;
      if (length >= leastLength(laws, line, 0, line.count))
        this.place(length, fitting.lots[number], fitting.ids[number]);
    }
  }

  /** Grows the lines of all seeds. */
  *grow(least: number): Generator<number, void, void> {
    const { laws, heap, grower } = this;
    const { line } = grower;
    let looked = 0;
    for (let seed = heap.pop(); seed; seed = heap.pop()) {
      if (++looked % CHUNK === 0) yield 1;
      if (!grower.grow(seed.x, seed.y, seed.lot)) continue;
      const length = (line.count - 1) * STEP * laws.pen;
      if (length < (least > LEAST * laws.pen ? least : leastLength(laws, line, 0, line.count))) continue;
      if (length < LONG_ENOUGH * heap.longest && length < LONG_ENOUGH * seed.length) heap.push({ ...seed, length });
      else this.place(length, seed.lot);
    }
  }

  private place(length: number, lot: number, id?: number): void {
    const { points, laws, grower } = this;
    const { line } = grower;
    points.pushLine(line, lot, id);
    const apart = Math.min(Math.max(length * SEEDS_ALONG, SEEDS_APART[0] * laws.pen), SEEDS_APART[1] * laws.pen);
    const every = Math.max(Math.round(apart / (STEP * laws.pen)), 1);
    for (let i = 0; i < line.count; i++) {
      if (i % every !== 0 && i !== line.count - 1) continue;
      for (const side of [1, -1])
        this.sowBeside(line.x[i], line.y[i], -side * line.uy[i], side * line.ux[i], line.apart[i], length);
    }
  }

  /** Sows a seed at the distance that is asked for in the middle between it and a point of a line. */
  private sowBeside(x: number, y: number, wayX: number, wayY: number, apart: number, length: number): void {
    const { laws } = this;
    let asked = apart;
    for (let k = 0; k < 2; k++) asked = 0.5 * (asked + laws.look(x + asked * wayX, y + asked * wayY));
    const [seedX, seedY] = [x + asked * wayX, y + asked * wayY];
    if (laws.fields.sheet.isParted(x, y, seedX, seedY)) return;
    this.push(seedX, seedY, LONGER * length);
  }

  private push(x: number, y: number, length: number): void {
    this.heap.push({ x, y, length, lot: (GOLDEN * ++this.number) % 1 });
  }
}
