import { type Cells, type CoarseGraph, clusterNodes, coarsen } from '../../adjacency/cells.js';
import { asPhase, forEachChunk } from '../../phases.js';
import { coarsenSeam } from './coarsenSeam.js';
import type { PhaseMatrix } from './phaseMatrix.js';

/** One level of the hierarchy: the fans, then cells of fans, then cells of cells. */
export interface PhaseLevel {
  matrix: PhaseMatrix;
  /** For each node a fan of it: the seed of its cell, of which the seed … */
  fans: Uint32Array;
  /** The cells that are the nodes of the next level, or null in the last one. */
  cells: Cells | null;
}

/** A level with at most this many nodes that have neighbours is the last one. */
const FEWEST_NODES = 60;

/** A level that keeps a larger share of these nodes is not built. */
const LARGEST_SHARE = 0.7;

/** Builds the hierarchy: each level merges the nodes of the one before with their neighbours. No cell crosses the cut. */
export function* phaseLevels(matrix: PhaseMatrix): Generator<number, PhaseLevel[], void> {
  const fans = new Uint32Array(matrix.diagonal.length);
  for (let fan = 0; fan < fans.length; fan++) fans[fan] = fan;
  const levels: PhaseLevel[] = [{ matrix, fans, cells: null }];
  for (let done = 0; ; done += 0.7 * (1 - done)) {
    const last = levels[levels.length - 1];
    const nodeCount = linkedNodes(last.matrix);
    if (nodeCount <= FEWEST_NODES) return levels;
    const cells = yield* asPhase(clusterNodes(last.matrix, 1, last.matrix.walls), done, done + 0.3 * (1 - done));
    const coarse = yield* asPhase(coarsenMatrix(last.matrix, cells), done + 0.3 * (1 - done), done + 0.7 * (1 - done));
    if (linkedNodes(coarse) > LARGEST_SHARE * nodeCount) return levels;
    last.cells = cells;
    levels.push({ matrix: coarse, fans: cells.seeds.map((node) => last.fans[node]), cells: null });
  }
}

/** The number of nodes with neighbours. The others are parts of their own. */
function linkedNodes({ starts }: PhaseMatrix): number {
  let count = 0;
  for (let node = 0; node < starts.length - 1; node++) if (starts[node + 1] > starts[node]) count++;
  return count;
}

/** The matrix for values that are constant in each cell. */
function* coarsenMatrix(matrix: PhaseMatrix, cells: Cells): Generator<number, PhaseMatrix, void> {
  const graph = yield* asPhase(coarsen(matrix, cells), 0, 0.5);
  const coarse: PhaseMatrix = {
    starts: graph.starts,
    neighbours: graph.neighbours,
    values: new Float64Array(graph.neighbours.length),
    diagonal: new Float64Array(cells.count),
    walls: new Uint8Array(graph.neighbours.length),
    seam: coarsenSeam(matrix.seam, cells.ofNode),
  };
  const votes = new Int32Array(graph.neighbours.length);
  yield* asPhase(
    forEachChunk(cells.ofNode.length, (start, end) => sumRange(matrix, cells.ofNode, graph, coarse, votes, start, end)),
    0.5,
    1,
  );
  for (let entry = 0; entry < votes.length; entry++) if (votes[entry] > 0) coarse.walls[entry] = 1;
  for (let cell = 0; cell < cells.count; cell++) if (!(coarse.diagonal[cell] > 0)) coarse.diagonal[cell] = 1;
  return coarse;
}

/**
 * Adds the rows of a range of nodes to those of their cells. Entries within a cell add to its diagonal. Each entry votes on whether the cut
 * divides its cells.
 */
function sumRange(
  { starts, values, diagonal, walls }: PhaseMatrix,
  ofNode: Uint32Array,
  { ofEntry }: CoarseGraph,
  coarse: PhaseMatrix,
  votes: Int32Array,
  start: number,
  end: number,
): void {
  for (let node = start; node < end; node++) {
    let own = diagonal[node];
    for (let entry = starts[node]; entry < starts[node + 1]; entry++) {
      const to = ofEntry[entry];
      if (to < 0) own += values[entry];
      else {
        coarse.values[to] += values[entry];
        votes[to] += walls[entry] === 1 ? 1 : -1;
      }
    }
    coarse.diagonal[ofNode[node]] += own;
  }
}
