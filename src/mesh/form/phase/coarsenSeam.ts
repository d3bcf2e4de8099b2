import { hashWords } from '../../hashWords.js';
import type { SeamEdges } from './phaseMatrix.js';

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
