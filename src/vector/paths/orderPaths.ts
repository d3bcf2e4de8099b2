import { asPhase } from '../../mesh/phases.js';
import { improveOrder, type OrderedPath, type PathEnds } from './improveOrder.js';

export type { OrderedPath, PathEnds };

function distance(a: readonly [number, number], b: readonly [number, number]): number {
  const [dx, dy] = [a[0] - b[0], a[1] - b[1]];
  return Math.sqrt(dx * dx + dy * dy);
}

/** The travel of the lifted pen, from the origin on. */
export function travelOf(paths: readonly PathEnds[], order: readonly OrderedPath[]): number {
  let [place, sum]: [readonly [number, number], number] = [[0, 0], 0];
  for (const { path, isReversed } of order) {
    const { start, end } = paths[path];
    sum += distance(place, isReversed ? end : start);
    place = isReversed ? start : end;
  }
  return sum;
}

/** The order as given. */
export const asDrawn = (paths: readonly PathEnds[]): OrderedPath[] =>
  paths.map((_, path) => ({ path, isReversed: false }));

/** Orders paths for a short travel of the lifted pen: nearest end first, then by local search. Yields its progress. */
export function* orderPaths(paths: readonly PathEnds[]): Generator<number, OrderedPath[], void> {
  const order = yield* asPhase(nearestFirst(paths), 0, 0.3);
  yield* asPhase(improveOrder(paths, order), 0.3, 1);
  return order;
}

/** Ends of paths in the cells of a grid. An end has the index of its path times two, plus one for the second end. */
class EndGrid {
  private readonly cells: number[][];
  private readonly size: number;
  private readonly columns: number;
  private readonly least: readonly [number, number];
  private readonly used: Uint8Array;

  constructor(private readonly paths: readonly PathEnds[]) {
    const ends = paths.flatMap(({ start, end }) => [start, end]);
    const lowest = (axis: 0 | 1) => ends.reduce((least, end) => Math.min(least, end[axis]), Infinity);
    const highest = (axis: 0 | 1) => ends.reduce((most, end) => Math.max(most, end[axis]), -Infinity);
    this.least = [lowest(0), lowest(1)];
    const count = Math.max(1, Math.ceil(Math.sqrt(paths.length)));
    this.size = Math.max(highest(0) - this.least[0], highest(1) - this.least[1], 1e-9) / count;
    this.columns = count + 1;
    this.cells = Array.from({ length: this.columns ** 2 }, () => []);
    this.used = new Uint8Array(paths.length);
    for (const [i, end] of ends.entries()) {
      const [column, row] = this.cellOf(end);
      this.cells[column + this.columns * row].push(i);
    }
  }

  private cellOf(place: readonly [number, number]): readonly [number, number] {
    const at = (axis: 0 | 1) =>
      Math.min(this.columns - 1, Math.max(0, Math.floor((place[axis] - this.least[axis]) / this.size)));
    return [at(0), at(1)];
  }

  /** Removes and returns the end nearest to a position. */
  take(place: readonly [number, number]): number {
    const [column, row] = this.cellOf(place);
    let [best, nearest] = [-1, Infinity];
    for (let ring = 0; ring < this.columns; ring++) {
      // Ends in rings farther out are at least this far away, for a position within its cell.
      if (best >= 0 && (ring - 1) * this.size > nearest) break;
      for (const cell of this.ringAround(column, row, ring)) {
        let kept = 0;
        for (const end of cell) {
          if (this.used[end >> 1]) continue;
          cell[kept++] = end;
          const path = this.paths[end >> 1];
          const away = distance(place, end & 1 ? path.end : path.start);
          if (away > nearest || (away === nearest && end > best)) continue;
          best = end;
          nearest = away;
        }
        cell.length = kept;
      }
    }
    this.used[best >> 1] = 1;
    return best;
  }

  private *ringAround(column: number, row: number, ring: number): Generator<number[], void, void> {
    for (let y = row - ring; y <= row + ring; y++) {
      if (y < 0 || y >= this.columns) continue;
      const isWhole = y === row - ring || y === row + ring;
      for (let x = column - ring; x <= column + ring; x += isWhole ? 1 : 2 * ring) {
        if (x >= 0 && x < this.columns) yield this.cells[x + this.columns * y];
      }
    }
  }
}

export function* nearestFirst(paths: readonly PathEnds[]): Generator<number, OrderedPath[], void> {
  const grid = new EndGrid(paths);
  const order: OrderedPath[] = [];
  let place: readonly [number, number] = [0, 0];
  for (let i = 0; i < paths.length; i++) {
    const end = grid.take(place);
    const [path, isReversed] = [end >> 1, (end & 1) === 1];
    order.push({ path, isReversed });
    place = isReversed ? paths[path].start : paths[path].end;
    if (i % 64 === 63) yield i / paths.length;
  }
  return order;
}
