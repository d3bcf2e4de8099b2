import type { LineFields } from './LineFields.js';
import type { LinePoints } from './LinePoints.js';

/** Width of a square of the map, in widths of the pen. */
const SQUARE = 20 / 3;
/** The greatest change in one round, and in all. */
const CHANGE = [0.7, 1.4] as const;
const RANGE = [0.6, 1.6] as const;
/** The share of a square up to which tone teaches nothing, and ink that is added to both sides, so that little tone changes little. */
const LEAST = 0.25;

const within = (value: number, [least, most]: readonly [number, number]): number =>
  Math.min(Math.max(value, least), most);

/** A map of the factors on tone that make the ink of lines what is asked for around each place. */
export class ToneGains {
  private readonly columns: number;
  private readonly rows: number;
  private readonly side: number;
  private readonly gains: Float32Array;

  constructor(
    private readonly fields: LineFields,
    private readonly pen: number,
  ) {
    this.side = SQUARE * pen;
    this.columns = Math.ceil(fields.sheet.width / this.side) + 2;
    this.rows = Math.ceil(fields.sheet.height / this.side) + 2;
    this.gains = new Float32Array(this.columns * this.rows).fill(1);
  }

  /** The factor at a place, millimetres. */
  at(x: number, y: number): number {
    const { columns, rows, side, gains } = this;
    const atX = Math.min(Math.max(x / side - 0.5, 0), columns - 1.001);
    const atY = Math.min(Math.max(y / side - 0.5, 0), rows - 1.001);
    const [column, row] = [Math.floor(atX), Math.floor(atY)];
    const [u, v] = [atX - column, atY - row];
    const i = row * columns + column;
    return (
      (1 - v) * ((1 - u) * gains[i] + u * gains[i + 1]) +
      v * ((1 - u) * gains[i + columns] + u * gains[i + columns + 1])
    );
  }

  /** Learns from lines of a set. */
  learn(set: number, points: LinePoints): void {
    const { fields, side, pen, gains } = this;
    const least = LEAST * side ** 2;
    const wanted = new Float32Array(gains.length);
    const drawn = new Float32Array(gains.length);
    const square = (x: number, y: number): number => Math.floor(y / side) * this.columns + Math.floor(x / side);
    for (let row = 0; row < fields.rows; row++)
      for (let column = 0; column < fields.columns; column++)
        wanted[square(column * fields.size, row * fields.size)] +=
          fields.size ** 2 * fields.densityOf(set, row * fields.columns + column);
    for (let i = 1; i < points.count; i++) {
      if (points.line[i] !== points.line[i - 1]) continue;
      const length = Math.hypot(points.x[i] - points.x[i - 1], points.y[i] - points.y[i - 1]);
      drawn[square(points.x[i], points.y[i])] += length * pen;
    }
    const [asked, got] = [this.spread(wanted), this.spread(drawn)];
    for (let i = 0; i < gains.length; i++) {
      if (asked[i] <= least) continue;
      gains[i] = within(gains[i] * within((asked[i] + least) / (got[i] + least), CHANGE), RANGE);
    }
  }

  /** Sums over the squares around each, twice. */
  private spread(numbers: Float32Array): Float32Array {
    const { columns, rows } = this;
    let from = numbers;
    for (let round = 0; round < 2; round++) {
      const sums = new Float32Array(from.length);
      for (let row = 0; row < rows; row++)
        for (let column = 0; column < columns; column++)
          for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, rows - 1); y++)
            for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, columns - 1); x++)
              sums[row * columns + column] += from[y * columns + x];
      from = sums;
    }
    return from;
  }
}
