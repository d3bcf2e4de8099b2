import { chunkPhase, forEachChunk, release } from '../phases.js';

/** A graph: the neighbours of node i lie in entries starts[i] … starts[i + 1] − 1. Each edge has two entries, one for each end. */
export interface Graph {
  starts: Uint32Array;
  neighbours: Uint32Array;
}

/** The parent of a seed, and the coarse entry of an entry within a cell: none. */
export const NONE = -1;

/** A division of the nodes of a graph into connected cells, each grown around a seed. */
export interface Cells {
  count: number;
  /** For each node the number of its cell. */
  ofNode: Uint32Array;
  /** For each cell the node it was grown from. */
  seeds: Uint32Array;
  /** All nodes, first the seeds in the order of their cells, and each after its parent. */
  order: Uint32Array;
  /** For each node the one that it was reached from, or NONE. */
  parents: Int32Array;
  /** For each node the entry, in the row of its parent, that it was reached by, or NONE. */
  parentEntries: Int32Array;
}

/**
 * Divides the nodes into cells. In the order of their numbers, nodes that lie farther than `rings` edges from all seeds before
 * become seeds; then each node joins the seed that is fewest edges away. It takes linear time, and depends on nothing but the
 * order of nodes and entries.
 *
 * @param rings how many edges seeds lie apart, at least
 * @param isWall for each entry of the graph 1 where cells must not grow across it; the two entries of an edge are alike
 */
export function* clusterNodes(graph: Graph, rings: number, isWall?: Uint8Array): Generator<number, Cells, void> {
  const nodeCount = graph.starts.length - 1;
  const order = new Uint32Array(nodeCount);
  const search: SeedSearch = {
    isWall,
    rings,
    seeds: order,
    seedCount: 0,
    queue: new Uint32Array(nodeCount),
    depths: new Uint32Array(nodeCount),
    stamps: new Int32Array(nodeCount).fill(NONE),
  };
  yield* chunkPhase(nodeCount, 0, 0.5, (start, end) => seedRange(graph, search, start, end));
  release(search.depths, search.stamps);
  const count = search.seedCount;
  const ofNode = search.queue;
  const cells: Cells = {
    count,
    ofNode,
    seeds: order.slice(0, count),
    order,
    parents: new Int32Array(nodeCount).fill(NONE),
    parentEntries: new Int32Array(nodeCount).fill(NONE),
  };
  ofNode.fill(UNREACHED);
  for (let cell = 0; cell < count; cell++) ofNode[order[cell]] = cell;
  let reached = count;
  yield* chunkPhase(nodeCount, 0.5, 1, (start, end) => {
    reached = growRange(graph, isWall, cells, reached, start, end);
  });
  return cells;
}

/** The cell of a node that none has reached yet. */
const UNREACHED = 0xffffffff;

/** State of the search for seeds between ranges. */
interface SeedSearch {
  isWall: Uint8Array | undefined;
  rings: number;
  seeds: Uint32Array;
  seedCount: number;
  /** The nodes around the current seed, in the order in which they were reached. */
  queue: Uint32Array;
  /** For each node its distance from the seed that reached it last. */
  depths: Uint32Array;
  /** For each node the number of the seed that reached it last, or NONE. */
  stamps: Int32Array;
}

function seedRange({ starts, neighbours }: Graph, search: SeedSearch, start: number, end: number): void {
  const { isWall, rings, seeds, queue, depths, stamps } = search;
  let { seedCount } = search;
  for (let seed = start; seed < end; seed++) {
    if (stamps[seed] !== NONE) continue;
    seeds[seedCount] = queue[0] = seed;
    stamps[seed] = seedCount;
    depths[seed] = 0;
    let length = 1;
    for (let head = 0; head < length && depths[queue[head]] < rings; head++) {
      const node = queue[head];
      for (let entry = starts[node]; entry < starts[node + 1]; entry++) {
        const neighbour = neighbours[entry];
        if (stamps[neighbour] === seedCount || isWall?.[entry] === 1) continue;
        stamps[neighbour] = seedCount;
        depths[neighbour] = depths[node] + 1;
        queue[length++] = neighbour;
      }
    }
    seedCount++;
  }
  search.seedCount = seedCount;
}

/** Extends the cells of a range of `order` to its neighbours. Returns the number of nodes reached so far. */
function growRange(
  { starts, neighbours }: Graph,
  isWall: Uint8Array | undefined,
  { ofNode, order, parents, parentEntries }: Cells,
  reachedBefore: number,
  start: number,
  end: number,
): number {
  let reached = reachedBefore;
  for (let i = start; i < end; i++) {
    const node = order[i];
    for (let entry = starts[node]; entry < starts[node + 1]; entry++) {
      const neighbour = neighbours[entry];
      if (ofNode[neighbour] !== UNREACHED || isWall?.[entry] === 1) continue;
      ofNode[neighbour] = ofNode[node];
      parents[neighbour] = node;
      parentEntries[neighbour] = entry;
      order[reached++] = neighbour;
    }
  }
  return reached;
}

/** A graph whose nodes are the cells of a finer one. */
export interface CoarseGraph extends Graph {
  /** For each entry of the finer graph, the coarse entry to which its value adds, or NONE within a cell. */
  ofEntry: Int32Array;
}

/** Merges the nodes of each cell into one. Cells are neighbours if nodes of theirs are. It takes linear time. */
export function* coarsen(graph: Graph, { ofNode, count }: Cells): Generator<number, CoarseGraph, void> {
  const nodeCount = ofNode.length;
  const ends = new Uint32Array(count + 1);
  for (let node = 0; node < nodeCount; node++) ends[ofNode[node]]++;
  for (let cell = 1; cell <= count; cell++) ends[cell] += ends[cell - 1];
  const members = new Uint32Array(nodeCount);
  for (let node = nodeCount - 1; node >= 0; node--) members[--ends[ofNode[node]]] = node;
  const starts = new Uint32Array(count + 1);
  const neighbours = new Uint32Array(countBetween(graph, ofNode));
  const ofEntry = new Int32Array(graph.neighbours.length);
  const marks = new Int32Array(count).fill(NONE);
  const coarse = { starts, neighbours, ofEntry };
  yield* forEachChunk(count, (start, end) => joinRange(graph, ofNode, members, ends, coarse, marks, start, end));
  const joined = neighbours.slice(0, starts[count]);
  release(members, ends, marks, neighbours);
  return { starts, neighbours: joined, ofEntry };
}

/** The number of entries that lead from one cell to another. */
function countBetween({ starts, neighbours }: Graph, ofNode: Uint32Array): number {
  let count = 0;
  for (let node = 0; node < ofNode.length; node++) {
    const cell = ofNode[node];
    for (let entry = starts[node]; entry < starts[node + 1]; entry++) if (ofNode[neighbours[entry]] !== cell) count++;
  }
  return count;
}

/**
 * Writes the rows of a range of cells.
 *
 * @param firsts where the members of each cell begin
 * @param marks for each cell the last entry that leads to it
 */
function joinRange(
  graph: Graph,
  ofNode: Uint32Array,
  members: Uint32Array,
  firsts: Uint32Array,
  { starts, neighbours, ofEntry }: CoarseGraph,
  marks: Int32Array,
  start: number,
  end: number,
): void {
  let total = starts[start];
  for (let cell = start; cell < end; cell++) {
    const rowStart = total;
    for (let m = firsts[cell]; m < firsts[cell + 1]; m++) {
      const node = members[m];
      for (let entry = graph.starts[node]; entry < graph.starts[node + 1]; entry++) {
        const other = ofNode[graph.neighbours[entry]];
        if (other === cell) {
          ofEntry[entry] = NONE;
          continue;
        }
        if (marks[other] < rowStart) {
          marks[other] = total;
          neighbours[total++] = other;
        }
        ofEntry[entry] = marks[other];
      }
    }
    starts[cell + 1] = total;
  }
}
