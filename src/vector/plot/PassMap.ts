import { type LinePath, PATH_STRIDE } from '../paths/LinePath.js';

/** Cells across the thinnest pen, and the most cells of a picture: larger pictures have larger ones. */
const CELLS_ACROSS = 6;
const MOST_CELLS = 1 << 25;
/** Places across a line that are looked at on each side of its middle, and the step between them in widths of the pen. */
const PLACES_ASIDE = 2;
const ASIDE = 1 / (2 * PLACES_ASIDE + 1);
/** The longest piece of a path that is counted at once, in widths of the pen. */
const LONGEST = 4;
/** Marks cells that the path being added covers already, above all counts. */
const OWN = 1 << 7;
const MOST_COUNT = OWN - 1;

/** How often pens pass over the places of a picture, counted in cells. Lengths in pixels of the picture. */
export class PassMap {
  private readonly size: number;
  private readonly columns: number;
  private readonly rows: number;
  private readonly counts: Uint8Array;
  /** The cells that the path being added covers. */
  private readonly own: number[] = [];

  /** @param pen width of the thinnest pen */
  constructor(width: number, height: number, pen: number) {
    this.size = Math.max(pen / CELLS_ACROSS, Math.sqrt((width * height) / MOST_CELLS));
    [this.columns, this.rows] = [width, height].map((side) => Math.ceil(side / this.size));
    this.counts = new Uint8Array(this.columns * this.rows);
  }

  /** The share of the width of a line that has so many passes at a place. dx, dy: its direction, a unit vector. */
  fullAcross(x: number, y: number, dx: number, dy: number, pen: number, passes: number): number {
    let full = 0;
    for (let k = -PLACES_ASIDE; k <= PLACES_ASIDE; k++) {
      const way = ASIDE * k * pen;
      full += Number(this.countAt(x - way * dy, y + way * dx) >= passes);
    }
    return ASIDE * full;
  }

  /** The share of a disc that has so many passes. */
  fullShare(x: number, y: number, radius: number, passes: number): number {
    let [full, all] = [0, 0];
    this.overSegment(x, y, 0, 0, radius, (cell) => {
      all++;
      full += Number(this.counts[cell] >= passes);
    });
    return all > 0 ? full / all : 0;
  }

  /** Counts one pass over all that a path covers, also where it crosses itself. */
  addPath({ points, isClosed }: LinePath, pen: number): void {
    const count = points.length / PATH_STRIDE;
    for (let i = 1; i < count + Number(isClosed); i++) {
      const [from, to] = [i - 1, i % count].map((k) => PATH_STRIDE * k);
      const [x, y] = [points[from], points[from + 1]];
      const [dx, dy] = [points[to] - x, points[to + 1] - y];
      // Short pieces, since all cells of the box around one are looked at.
      const steps = Math.max(Math.ceil(Math.hypot(dx, dy) / (LONGEST * pen)), 1);
      for (let k = 0; k < steps; k++) {
        const share = k / steps;
        this.overSegment(x + share * dx, y + share * dy, dx / steps, dy / steps, pen / 2, this.mark);
      }
    }
    this.countMarked();
  }

  /** Counts one pass over a disc. */
  addDisc(x: number, y: number, radius: number): void {
    this.overSegment(x, y, 0, 0, radius, this.mark);
    this.countMarked();
  }

  private countAt(x: number, y: number): number {
    const [column, row] = [Math.floor(x / this.size), Math.floor(y / this.size)];
    const isInside = column >= 0 && column < this.columns && row >= 0 && row < this.rows;
    return isInside ? this.counts[row * this.columns + column] : 0;
  }

  private readonly mark = (cell: number): void => {
    if (this.counts[cell] & OWN) return;
    this.counts[cell] |= OWN;
    this.own.push(cell);
  };

  private countMarked(): void {
    const { counts, own } = this;
    for (const cell of own) counts[cell] = Math.min((counts[cell] & ~OWN) + 1, MOST_COUNT);
    own.length = 0;
  }

  /** Calls a function for the cells whose middles lie within a distance of a straight segment. */
  private overSegment(
    x: number,
    y: number,
    dx: number,
    dy: number,
    radius: number,
    visit: (cell: number) => void,
  ): void {
    const { size, columns, rows } = this;
    const square = dx * dx + dy * dy;
    const first = (value: number): number => Math.max(Math.ceil((value - radius) / size - 0.5), 0);
    const last = (value: number, count: number): number =>
      Math.min(Math.floor((value + radius) / size - 0.5), count - 1);
    const [left, right] = [first(x + Math.min(dx, 0)), last(x + Math.max(dx, 0), columns)];
    const bottom = last(y + Math.max(dy, 0), rows);
    for (let row = first(y + Math.min(dy, 0)); row <= bottom; row++) {
      for (let column = left; column <= right; column++) {
        const [px, py] = [(column + 0.5) * size - x, (row + 0.5) * size - y];
        const t = square > 0 ? Math.min(Math.max((px * dx + py * dy) / square, 0), 1) : 0;
        if ((px - t * dx) ** 2 + (py - t * dy) ** 2 <= radius * radius) visit(row * columns + column);
      }
    }
  }
}
