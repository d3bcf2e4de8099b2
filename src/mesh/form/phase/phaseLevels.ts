import { type Cells, type CoarseGraph, clusterNodes, coarsen } from '../../adjacency/cells.js';
import { hashWords } from '../../hashWords.js';
import { asPhase, chunkPhase } from '../../phases.js';
import type { PhaseMatrix, SeamEdges } from './phaseMatrix.js';

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
  yield* chunkPhase(cells.ofNode.length, 0.5, 1, (start, end) =>
    sumRange(matrix, cells.ofNode, graph, coarse, votes, start, end),
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

/**
 * The edges of the cut between cells. Those between the same cells, with the same signs and offsets, become one with the sum of
 * their weights: few are left of a long segment. An edge whose ends always agree is left out.
 *
 * @param ofNode for each node the number of its cell
 */
export function coarsenSeam(seam: SeamEdges, ofNode: Uint32Array): SeamEdges {
  const coarse: SeamEdges = {
    nodes: seam.nodes.map((node) => ofNode[node]),
    signs: seam.signs.slice(),
    offsets: seam.offsets.slice(),
    weights: new Float64Array(seam.weights.length),
  };
  // A hash table with open addressing: the number of an edge + 1, or 0 in an empty slot.
  const table = new Uint32Array(2 ** Math.ceil(Math.log2(2 * seam.weights.length + 1)));
  let count = 0;
  for (let edge = 0; edge < seam.weights.length; edge++) {
    turn(coarse, edge);
    if (endsAgree(coarse, edge)) continue;
    const slot = slotOf(coarse, edge, table);
    if (table[slot] === 0) {
      move(coarse, edge, count);
      table[slot] = ++count;
    }
    coarse.weights[table[slot] - 1] += seam.weights[edge];
  }
  return {
    nodes: coarse.nodes.slice(0, 2 * count),
    signs: coarse.signs.slice(0, 2 * count),
    offsets: coarse.offsets.slice(0, 2 * count),
    weights: coarse.weights.slice(0, count),
  };
}

/** Turns an edge around so that its ends stand in the order of their nodes, and of their offsets where these are the same. */
function turn({ nodes, signs, offsets }: SeamEdges, edge: number): void {
  const a = 2 * edge;
  const b = a + 1;
  if (nodes[a] < nodes[b] || (nodes[a] === nodes[b] && offsets[a] <= offsets[b])) return;
  [nodes[a], nodes[b]] = [nodes[b], nodes[a]];
  [signs[a], signs[b]] = [signs[b], signs[a]];
  [offsets[a], offsets[b]] = [offsets[b], offsets[a]];
}

function endsAgree({ nodes, signs, offsets }: SeamEdges, edge: number): boolean {
  const a = 2 * edge;
  const b = a + 1;
  return nodes[a] === nodes[b] && signs[a] === signs[b] && offsets[a] === offsets[b];
}

/** The slot of an edge that is like this one, or an empty slot where there is none. */
function slotOf(seam: SeamEdges, edge: number, table: Uint32Array): number {
  const { nodes, offsets } = seam;
  const a = 2 * edge;
  const mask = table.length - 1;
  let slot = hashWords(nodes[a], nodes[a + 1], hashWords(offsets[a], offsets[a + 1], 0)) & mask;
  while (table[slot] > 0 && !isAlike(seam, edge, table[slot] - 1)) slot = (slot + 1) & mask;
  return slot;
}

function isAlike({ nodes, signs, offsets }: SeamEdges, edge: number, other: number): boolean {
  for (let end = 0; end < 2; end++) {
    const a = 2 * edge + end;
    const b = 2 * other + end;
    if (nodes[a] !== nodes[b] || signs[a] !== signs[b] || offsets[a] !== offsets[b]) return false;
  }
  return true;
}

function move({ nodes, signs, offsets }: SeamEdges, from: number, to: number): void {
  nodes.copyWithin(2 * to, 2 * from, 2 * from + 2);
  signs.copyWithin(2 * to, 2 * from, 2 * from + 2);
  offsets.copyWithin(2 * to, 2 * from, 2 * from + 2);
}
