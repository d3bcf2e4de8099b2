import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { consistentTwin } from '../adjacency/consistentTwin.js';
import { nextCorner } from '../mesh/corners.js';
import { disjointSets, join, rootOf } from '../mesh/disjointSets.js';
import { asPhase } from '../slices/asPhase.js';
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

type Adjacency = Pick<TriangleAdjacency, 'twins' | 'canonicalCorners'>;

/**
 * Finds the fans. They continue across welded seams. They end at borders, at creases that were cut before, and at edges
 * where the windings contradict each other. Near-linear, also where 100,000 triangles meet.
 */
export function* buildFans(adjacency: Adjacency): Generator<number, Fans, void> {
  const cornerCount = adjacency.twins.length;
  const parents = disjointSets(cornerCount);
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => joinRange(adjacency, parents, start, end)),
    0,
    0.7,
  );
  const ofCorner = new Uint32Array(cornerCount);
  let count = 0;
  yield* asPhase(
    forEachChunk(cornerCount, (start, end) => {
      count = numberRange(parents, ofCorner, count, start, end);
    }),
    0.7,
    1,
  );
  return { ofCorner, count };
}

/** Joins the corners at both ends of an edge with those of its twin. */
function joinRange({ twins, canonicalCorners }: Adjacency, parents: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) {
    const twin = consistentTwin(twins, canonicalCorners, corner);
    if (twin < corner) continue;
    join(parents, corner, nextCorner(twin));
    join(parents, nextCorner(corner), twin);
  }
}

/** Numbers the fans of some corners; `count` are numbered already. The root is the smallest of its set, so it comes first. */
function numberRange(parents: Uint32Array, ofCorner: Uint32Array, count: number, start: number, end: number): number {
  let next = count;
  for (let corner = start; corner < end; corner++) {
    const root = rootOf(parents, corner);
    ofCorner[corner] = root === corner ? next++ : ofCorner[root];
  }
  return next;
}
