import { asPhase } from '../../mesh/phases.js';
import { Grid, improveOrder, type OrderedPath, type PathEnds, pointsOf } from './improveOrder.js';

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

/** Orders paths by the nearest end that is left. An end has the index of its path times two, plus one for the second end. */
function* nearestFirst(paths: readonly PathEnds[]): Generator<number, OrderedPath[], void> {
  const grid = new Grid(pointsOf(paths));
  const used = new Uint8Array(paths.length);
  const order: OrderedPath[] = [];
  let place: readonly [number, number] = [0, 0];
  for (let i = 0; i < paths.length; i++) {
    let [best, nearest] = [-1, Infinity];
    // Ends in rings farther out are at least this far away, for a position within its cell.
    for (let ring = 0; ring < grid.columns && !(best >= 0 && (ring - 1) * grid.size > nearest); ring++) {
      grid.visitRing(...place, ring, (cell) => {
        let kept = 0;
        for (const end of cell) {
          if (used[end >> 1]) continue;
          cell[kept++] = end;
          const path = paths[end >> 1];
          const away = distance(place, end & 1 ? path.end : path.start);
          if (away > nearest || (away === nearest && end > best)) continue;
          best = end;
          nearest = away;
        }
        cell.length = kept;
      });
    }
    const [path, isReversed] = [best >> 1, (best & 1) === 1];
    used[path] = 1;
    order.push({ path, isReversed });
    place = isReversed ? paths[path].start : paths[path].end;
    if (i % 64 === 63) yield i / paths.length;
  }
  return order;
}
