import { NO_TWIN, nextCorner, previousCorner } from '../mesh/corners.js';
import { forEachChunk } from '../slices/forEachChunk.js';

/**
 * A fan is a set of corners around a vertex that are connected across edges with twins. Over a fan the surface is smooth: a
 * vertex at a crease has one fan, and one normal, on either side of it.
 */
export interface Fans {
  /** For each corner the number of its fan. Fans are numbered in the order of their first corners. */
  ofCorner: Uint32Array<ArrayBuffer>;
  count: number;
}

/** In place of a fan, where there is none. */
export const NO_FAN = 0xffffffff;

/**
 * Finds the fans by walking around the vertices. They continue across welded seams. They end at borders, at creases that were
 * cut before, and at edges where the windings contradict each other. Linear, also where 100,000 triangles meet.
 *
 * @param twins without those of edges where the windings contradict each other (`consistentTwins`)
 */
export function* buildFans(twins: Int32Array): Generator<number, Fans, void> {
  const ofCorner = new Uint32Array(twins.length).fill(NO_FAN);
  let count = 0;
  yield* forEachChunk(twins.length, (start, end) => {
    count = walkRange(twins, ofCorner, count, start, end);
  });
  return { ofCorner, count };
}

/** Numbers the fans that begin in some corners; `count` are numbered already. */
function walkRange(twins: Int32Array, ofCorner: Uint32Array, count: number, start: number, end: number): number {
  let fan = count;
  for (let first = start; first < end; first++) {
    if (ofCorner[first] !== NO_FAN) continue;
    // Across the edges that start at the vertex, until the way round is closed or ends at a border …
    let corner = first;
    do {
      ofCorner[corner] = fan;
      const twin = twins[corner];
      corner = twin === NO_TWIN ? first : nextCorner(twin);
    } while (corner !== first);
    // … and from where it began across those that end there. A closed way has come by there already.
    for (let twin = twins[previousCorner(first)]; twin !== NO_TWIN && ofCorner[twin] === NO_FAN; ) {
      ofCorner[twin] = fan;
      twin = twins[previousCorner(twin)];
    }
    fan++;
  }
  return fan;
}
