/**
 * The nearest neighbours of each point, except the other point of its pair. A grid makes it nearly linear in time. Yields its progress.
 *
 * @param points x and y in turn; points 0 and 1 are a pair, and 2 and 3 …
 * @param count number of neighbours
 * @returns `count` indices per point, nearest first; −1 for none
 */
export function* nearestEnds(points: Float64Array, count: number): Generator<number, Int32Array, void> {
  const total = points.length / 2;
  const nearest = new Int32Array(total * count).fill(-1);
  const grid = new Grid(points);
  const distances = new Float64Array(count);
  for (let p = 0; p < total; p++) {
    if (p % 64 === 63) yield p / total;
    let found = 0;
    const [x, y] = [points[2 * p], points[2 * p + 1]];
    const add = (q: number): void => {
      if (q >> 1 === p >> 1) return;
      const [dx, dy] = [points[2 * q] - x, points[2 * q + 1] - y];
      const away = Math.sqrt(dx * dx + dy * dy);
      if (found === count && away >= distances[count - 1]) return;
      let i = found < count ? found++ : count - 1;
      for (; i > 0 && distances[i - 1] > away; i--) {
        distances[i] = distances[i - 1];
        nearest[p * count + i] = nearest[p * count + i - 1];
      }
      distances[i] = away;
      nearest[p * count + i] = q;
    };
    for (let ring = 0; ring <= grid.columns; ring++) {
      // Points in rings farther out are at least this far away.
      if (found === count && (ring - 1) * grid.size > distances[count - 1]) break;
      grid.visitRing(x, y, ring, add);
    }
  }
  return nearest;
}

/** Points in the cells of a square grid. */
class Grid {
  readonly columns: number;
  readonly size: number;
  private readonly left: number;
  private readonly top: number;
  private readonly cells: number[][];

  constructor(points: Float64Array) {
    let [right, bottom] = [-Infinity, -Infinity];
    let [left, top] = [Infinity, Infinity];
    for (let i = 0; i < points.length; i += 2) {
      [left, right] = [Math.min(left, points[i]), Math.max(right, points[i])];
      [top, bottom] = [Math.min(top, points[i + 1]), Math.max(bottom, points[i + 1])];
    }
    [this.left, this.top] = [left, top];
    this.columns = Math.max(1, Math.ceil(Math.sqrt(points.length / 4)));
    this.size = Math.max(right - left, bottom - top, 1e-9) / this.columns;
    this.cells = Array.from({ length: (this.columns + 1) ** 2 }, () => []);
    for (let p = 0; 2 * p < points.length; p++) this.cells[this.cellOf(points[2 * p], points[2 * p + 1])].push(p);
  }

  private cellOf(x: number, y: number): number {
    return Math.floor((x - this.left) / this.size) + (this.columns + 1) * Math.floor((y - this.top) / this.size);
  }

  /** Calls back for the points in a ring of cells around that of a position. */
  visitRing(x: number, y: number, ring: number, call: (point: number) => void): void {
    const width = this.columns + 1;
    const cell = this.cellOf(x, y);
    const [column, row] = [cell % width, Math.floor(cell / width)];
    for (let r = Math.max(row - ring, 0); r <= Math.min(row + ring, this.columns); r++) {
      const step = Math.abs(r - row) === ring || ring === 0 ? 1 : 2 * ring;
      for (let c = column - ring; c <= column + ring; c += step) {
        if (c >= 0 && c < width) for (const point of this.cells[c + width * r]) call(point);
      }
    }
  }
}
