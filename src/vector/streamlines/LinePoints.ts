import type { Sheet } from './Sheet.js';

/** Points that lines have room for at first. */
const FIRST = 1 << 12;
const NONE = -1;
/** What is no number of a line. */
export const UNNUMBERED = -1;

/** The first `count` points of a line with their directions and the distances asked for there. */
type LineCourse = { count: number } & Readonly<Record<'x' | 'y' | 'ux' | 'uy' | 'apart', Float64Array>>;

/** The points of lines on a sheet, in a grid that finds those near a place. Lengths in millimetres. */
export class LinePoints {
  count = 0;
  x = new Float64Array(FIRST);
  y = new Float64Array(FIRST);
  /** The unit direction of the line. */
  ux = new Float64Array(FIRST);
  uy = new Float64Array(FIRST);
  /** The distance asked for between lines there. */
  apart = new Float64Array(FIRST);
  line = new Int32Array(FIRST);
  /** The first point of each line, and the end of the last. */
  readonly starts: number[] = [0];
  /** Per line its chance, from 0 to 1, and its number in the drawing; `UNNUMBERED` as long as it has none. */
  readonly lots: number[] = [];
  readonly ids: number[] = [];
  private next = new Int32Array(FIRST);
  private readonly heads: Int32Array;
  private readonly columns: number;
  private readonly rows: number;

  /** @param cell width of the cells of the grid */
  constructor(
    private readonly sheet: Sheet,
    private readonly cell: number,
  ) {
    this.columns = Math.ceil(sheet.width / cell) + 1;
    this.rows = Math.ceil(sheet.height / cell) + 1;
    this.heads = new Int32Array(this.columns * this.rows).fill(NONE);
  }

  get lines(): number {
    return this.starts.length - 1;
  }

  /** Adds a point to the line that is being written. */
  push(x: number, y: number, ux: number, uy: number, apart: number): void {
    if (this.count === this.x.length) this.grow();
    const i = this.count++;
    this.x[i] = x;
    this.y[i] = y;
    this.ux[i] = ux;
    this.uy[i] = uy;
    this.apart[i] = apart;
    this.line[i] = this.lines;
    this.register(i);
  }

  /** Writes a whole line. lot and id: see `endLine`. */
  pushLine({ count, x, y, ux, uy, apart }: LineCourse, lot: number, id = UNNUMBERED): void {
    for (let i = 0; i < count; i++) this.push(x[i], y[i], ux[i], uy[i], apart[i]);
    this.endLine(lot, id);
  }

  /** Ends the line that is being written. lot: its chance, from 0 to 1; and `id`, its number if it has one. */
  endLine(lot: number, id = UNNUMBERED): void {
    this.starts.push(this.count);
    this.lots.push(lot);
    this.ids.push(id);
  }

  /** Numbers the lines that have none. */
  numberLines(): void {
    let next = this.ids.reduce((most, id) => Math.max(most, id), UNNUMBERED) + 1;
    for (let line = 0; line < this.lines; line++) if (this.ids[line] === UNNUMBERED) this.ids[line] = next++;
  }

  /** Enters all points into the grid anew, after they have moved. */
  registerAll(): void {
    this.heads.fill(NONE);
    for (let i = 0; i < this.count; i++) this.register(i);
  }

  /** Whether a point within a radius of a place lies on the same side of all outlines. except: a line that does not count. */
  isTaken(x: number, y: number, radius: number, except = NONE): boolean {
    const { sheet, columns, heads, next } = this;
    const square = radius * radius;
    const left = this.columnOf(x - radius);
    const right = this.columnOf(x + radius);
    const top = this.rowOf(y - radius);
    const bottom = this.rowOf(y + radius);
    for (let row = top; row <= bottom; row++) {
      for (let column = left; column <= right; column++) {
        for (let i = heads[row * columns + column]; i !== NONE; i = next[i]) {
          const dx = this.x[i] - x;
          const dy = this.y[i] - y;
          if (dx * dx + dy * dy < square && this.line[i] !== except && !sheet.isParted(x, y, this.x[i], this.y[i]))
            return true;
        }
      }
    }
    return false;
  }

  /** The gaps that `gapsAt` has found, and the distances asked for on the other side of them; Infinity without a neighbour. */
  left = Infinity;
  right = Infinity;
  leftApart = 0;
  rightApart = 0;

  /**
   * Finds the nearest lines to the left and to the right of a point.
   *
   * @param reach the farthest that they may lie
   * @param along how far they may lie along the line
   */
  gapsAt(i: number, reach: number, along: number): void {
    const { sheet, columns, heads, next } = this;
    const x = this.x[i];
    const y = this.y[i];
    const ux = this.ux[i];
    const uy = this.uy[i];
    const own = this.line[i];
    this.left = this.right = Infinity;
    // Points lie in a strip across the line: of each row only the cells that it runs through are looked at.
    const farX = Math.min(reach * Math.abs(uy) + along * Math.abs(ux) + ROUNDING, reach);
    const farY = Math.min(reach * Math.abs(ux) + along * Math.abs(uy) + ROUNDING, reach);
    const across = Math.abs(ux) > LEAST_SLANT ? 1 / ux : 0;
    const half = across === 0 ? Infinity : Math.abs(along * across) + ROUNDING;
    const bottom = this.rowOf(y + farY);
    for (let row = this.rowOf(y - farY); row <= bottom; row++) {
      // Cells at the edges of the grid hold all that lies beyond them.
      const above = row === 0 ? -farY : Math.max(row * this.cell - y, -farY);
      const below = row === this.rows - 1 ? farY : Math.min((row + 1) * this.cell - y, farY);
      const fromX = -uy * across * above;
      const toX = -uy * across * below;
      const right = this.columnOf(x + Math.min(farX, Math.max(fromX, toX) + half));
      for (let column = this.columnOf(x + Math.max(-farX, Math.min(fromX, toX) - half)); column <= right; column++) {
        for (let j = heads[row * columns + column]; j !== NONE; j = next[j]) {
          const dx = this.x[j] - x;
          const dy = this.y[j] - y;
          if (Math.abs(dx * ux + dy * uy) > along) continue;
          const side = dy * ux - dx * uy;
          const gap = Math.abs(side);
          if (gap < LEAST_GAP || gap > reach || gap >= (side > 0 ? this.left : this.right)) continue;
          if (Math.abs(this.ux[j] * ux + this.uy[j] * uy) < ALIKE) continue;
          if (this.line[j] === own && Math.abs(i - j) * along < NEAR_ITSELF * this.apart[i]) continue;
          if (sheet.isParted(x, y, this.x[j], this.y[j])) continue;
          if (side > 0) {
            this.left = gap;
            this.leftApart = this.apart[j];
          } else {
            this.right = gap;
            this.rightApart = this.apart[j];
          }
        }
      }
    }
  }

  private columnOf(x: number): number {
    return Math.min(Math.max(Math.floor(x / this.cell), 0), this.columns - 1);
  }

  private rowOf(y: number): number {
    return Math.min(Math.max(Math.floor(y / this.cell), 0), this.rows - 1);
  }

  private register(i: number): void {
    const cell = this.rowOf(this.y[i]) * this.columns + this.columnOf(this.x[i]);
    this.next[i] = this.heads[cell];
    this.heads[cell] = i;
  }

  private grow(): void {
    const longer = <Numbers extends Float64Array | Int32Array>(numbers: Numbers): Numbers => {
      const Kind = numbers.constructor as new (length: number) => Numbers;
      const grown = new Kind(2 * numbers.length);
      grown.set(numbers);
      return grown;
    };
    for (const name of ['x', 'y', 'ux', 'uy', 'apart'] as const) this[name] = longer(this[name]);
    this.line = longer(this.line);
    this.next = longer(this.next);
  }
}

/** Points nearer than this are of the same place, millimetres; and the cosine from which on two lines count as parallel. */
const LEAST_GAP = 0.05;
const ALIKE = 0.8;
/** Room for rounding, millimetres; and the least slant of a line for which its strip is cut row by row. */
const ROUNDING = 1e-6;
const LEAST_SLANT = 1e-3;
/** A line that returns is its own neighbour after so many distances between lines. */
const NEAR_ITSELF = 3;
