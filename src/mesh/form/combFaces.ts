import { NO_TWIN, triangleOf } from '../corners.js';
import { disjointSets, join, rootOf } from '../disjointSets.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';
import type { FormSurface } from './FormSurface.js';

/** A sign for each face, 1 or −1, and for each edge 1 where the surface is cut. */
export interface Combing {
  flip: Int8Array<ArrayBuffer>;
  cut: Uint8Array<ArrayBuffer>;
}

/**
 * Gives each face a sign, along spanning trees over the faces, one per connected piece. All edges that no tree crosses are cut.
 *
 * The trees cross the edges farthest from `isEnd` first. The edges they leave form trees over the vertices with shortest paths to the ends,
 * so the cut joins ends to each other by short ways once its blind ends are trimmed.
 *
 * @param signs for each edge whether the directions beside it agree
 * @param isEnd for each fan whether the cut may end there
 */
export function* combFaces(
  { twins, fans, heat }: Pick<FormSurface, 'twins' | 'fans' | 'heat'>,
  signs: Int8Array,
  isEnd: (fan: number) => boolean,
): Generator<number, Combing, void> {
  const distances = yield* asPhase(distancesFromEnds(heat, fans.count, isEnd), 0, 0.2);
  const edges = yield* asPhase(nearestLast(twins, fans.ofCorner, distances), 0.2, 0.4);
  const cut = new Uint8Array(twins.length);
  const sets = disjointSets(twins.length / 3);
  yield* chunkPhase(edges.length, 0.4, 0.8, (start, end) => crossRange(twins, edges, sets, cut, start, end));
  const flip = yield* asPhase(spreadSigns(twins, signs, cut), 0.8, 1);
  return { flip, cut };
}

/** For each fan the number of edges to the nearest end. A piece without any end has one at its first fan. */
function* distancesFromEnds(
  { starts, neighbours }: FormSurface['heat'],
  fanCount: number,
  isEnd: (fan: number) => boolean,
): Generator<number, Int32Array, void> {
  const distances = new Int32Array(fanCount).fill(UNREACHED);
  const queue = new Uint32Array(fanCount);
  let reached = 0;
  for (let fan = 0; fan < fanCount; fan++) {
    if (!isEnd(fan)) continue;
    distances[fan] = 0;
    queue[reached++] = fan;
  }
  let first = 0;
  yield* forEachChunk(fanCount, (start, end) => {
    for (let i = start; i < end; i++) {
      if (i === reached) {
        while (distances[first] !== UNREACHED) first++;
        distances[first] = 0;
        queue[reached++] = first;
      }
      const fan = queue[i];
      for (let entry = starts[fan]; entry < starts[fan + 1]; entry++) {
        const neighbour = neighbours[entry];
        if (distances[neighbour] !== UNREACHED) continue;
        distances[neighbour] = distances[fan] + 1;
        queue[reached++] = neighbour;
      }
    }
  });
  return distances;
}

const UNREACHED = -1;

/** All edges between two faces, each by its later half, sorted by distance of their ends from the ends of the cut, farthest first. */
function* nearestLast(
  twins: Int32Array,
  ofCorner: Uint32Array,
  distances: Int32Array,
): Generator<number, Uint32Array, void> {
  let most = 0;
  for (let fan = 0; fan < distances.length; fan++) most = Math.max(most, distances[fan]);
  // The edges whose ends lie `farness` from the ends of the cut are at starts[2·most − farness] and after.
  const starts = new Uint32Array(2 * most + 2);
  yield* chunkPhase(twins.length, 0, 0.4, (start, end) =>
    countRange(twins, ofCorner, distances, most, starts, start, end),
  );
  for (let i = 1; i < starts.length; i++) starts[i] += starts[i - 1];
  const edges = new Uint32Array(starts[starts.length - 1]);
  yield* chunkPhase(twins.length, 0.4, 1, (start, end) =>
    sortRange(twins, ofCorner, distances, most, starts, edges, start, end),
  );
  return edges;
}

/** Counts edges one place after theirs. */
function countRange(
  twins: Int32Array,
  ofCorner: Uint32Array,
  distances: Int32Array,
  most: number,
  counts: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin === NO_TWIN || twin > corner) continue;
    counts[2 * most - distances[ofCorner[corner]] - distances[ofCorner[twin]] + 1]++;
  }
}

function sortRange(
  twins: Int32Array,
  ofCorner: Uint32Array,
  distances: Int32Array,
  most: number,
  starts: Uint32Array,
  edges: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin === NO_TWIN || twin > corner) continue;
    edges[starts[2 * most - distances[ofCorner[corner]] - distances[ofCorner[twin]]]++] = corner;
  }
}

/** Extends the trees across the edges of a range that join two of them, and cuts the others. */
function crossRange(
  twins: Int32Array,
  edges: Uint32Array,
  sets: Uint32Array,
  cut: Uint8Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const corner = edges[i];
    const face = triangleOf(corner);
    const neighbour = triangleOf(twins[corner]);
    if (rootOf(sets, face) === rootOf(sets, neighbour)) cut[corner] = cut[twins[corner]] = 1;
    else join(sets, face, neighbour);
  }
}

/** Gives signs to the faces that agree across all uncut edges. */
function* spreadSigns(
  twins: Int32Array,
  signs: Int8Array,
  cut: Uint8Array,
): Generator<number, Int8Array<ArrayBuffer>, void> {
  const faceCount = twins.length / 3;
  const flip = new Int8Array(faceCount);
  const queue = new Uint32Array(faceCount);
  let reached = 0;
  let root = 0;
  yield* forEachChunk(faceCount, (start, end) => {
    for (let head = start; head < end; head++) {
      if (head === reached) {
        while (flip[root] !== 0) root++;
        flip[root] = 1;
        queue[reached++] = root;
      }
      reached = reachNeighbours(twins, signs, cut, flip, queue, queue[head], reached);
    }
  });
  return flip;
}

/** Gives signs to the neighbours of a face. Returns the number of faces reached so far. */
function reachNeighbours(
  twins: Int32Array,
  signs: Int8Array,
  cut: Uint8Array,
  flip: Int8Array,
  queue: Uint32Array,
  face: number,
  reachedBefore: number,
): number {
  let reached = reachedBefore;
  for (let corner = 3 * face; corner < 3 * face + 3; corner++) {
    if (twins[corner] === NO_TWIN || cut[corner] === 1) continue;
    const neighbour = triangleOf(twins[corner]);
    if (flip[neighbour] !== 0) continue;
    flip[neighbour] = flip[face] * signs[corner];
    queue[reached++] = neighbour;
  }
  return reached;
}
