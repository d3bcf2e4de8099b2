import { NO_TWIN, nextCorner, previousCorner } from '../corners.js';
import { forEachChunk } from '../phases.js';

/**
 * A fan is a set of corners around a vertex that are connected across edges with twins. The surface is smooth within a fan: a
 * vertex on a crease has one fan, and so one normal, on each side of the crease.
 */
export interface Fans {
  /** For each corner the number of its fan. Fans are numbered in the order of their first corners. */
  ofCorner: Uint32Array<ArrayBuffer>;
  count: number;
}

/** Stands for the number of a fan where there is no fan. */
export const NO_FAN = 0xffffffff;

/**
 * Finds the fans by walking around the vertices. Fans continue across welded seams. They end at borders, at creases that were
 * cut before, and at edges where the windings contradict each other. It takes linear time, even if 100,000 triangles meet in
 * one vertex.
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

/** Numbers the fans that begin in a range of corners. `count` fans have a number already. */
function walkRange(twins: Int32Array, ofCorner: Uint32Array, count: number, start: number, end: number): number {
  let fan = count;
  for (let first = start; first < end; first++) {
    if (ofCorner[first] !== NO_FAN) continue;
    // Walk across the edges that start at the vertex, until the walk is back where it started or reaches a border …
    let corner = first;
    do {
      ofCorner[corner] = fan;
      const twin = twins[corner];
      corner = twin === NO_TWIN ? first : nextCorner(twin);
    } while (corner !== first);
    // … and then the other way, across the edges that end at the vertex. After a closed walk nothing is left to number.
    for (let twin = twins[previousCorner(first)]; twin !== NO_TWIN && ofCorner[twin] === NO_FAN; ) {
      ofCorner[twin] = fan;
      twin = twins[previousCorner(twin)];
    }
    fan++;
  }
  return fan;
}
