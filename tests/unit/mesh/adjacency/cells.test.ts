import { describe, expect, test } from 'vitest';
import { type Cells, clusterNodes, coarsen, type Graph, NONE } from '../../../../src/mesh/adjacency/cells.js';
import { finish } from '../meshes.js';

/** A graph from its edges. */
function graphOf(nodeCount: number, edges: readonly (readonly [number, number])[]): Graph {
  const rows = Array.from({ length: nodeCount }, (): number[] => []);
  for (const [a, b] of edges) {
    rows[a].push(b);
    rows[b].push(a);
  }
  const starts = new Uint32Array(nodeCount + 1);
  for (const [node, row] of rows.entries()) starts[node + 1] = starts[node] + row.length;
  return { starts, neighbours: Uint32Array.from(rows.flat()) };
}

const path = (nodeCount: number) =>
  graphOf(
    nodeCount,
    Array.from({ length: nodeCount - 1 }, (_, i) => [i, i + 1] as const),
  );

/** The edges of a strip of triangles, `width` nodes wide, with nodes numbered in pseudo-random order. */
function strip(width: number, length: number): Graph {
  const nodeCount = width * length;
  // 7919 is a prime that divides no size used here, so numbers are unique.
  const number = (x: number, y: number) => ((x + width * y) * 7919) % nodeCount;
  const edges: [number, number][] = [];
  for (let y = 0; y < length; y++) {
    for (let x = 0; x < width; x++) {
      if (x + 1 < width) edges.push([number(x, y), number(x + 1, y)]);
      if (y + 1 < length) edges.push([number(x, y), number(x, y + 1)]);
      if (x + 1 < width && y + 1 < length) edges.push([number(x, y), number(x + 1, y + 1)]);
    }
  }
  return graphOf(nodeCount, edges);
}

/** How many edges each node lies from the nearest seed. */
function distancesFrom({ starts, neighbours }: Graph, seeds: Iterable<number>): number[] {
  const queue = [...seeds];
  const distances = new Array<number>(starts.length - 1).fill(Infinity);
  for (const seed of queue) distances[seed] = 0;
  for (const node of queue) {
    for (const other of neighbours.subarray(starts[node], starts[node + 1])) {
      if (distances[other] < Infinity) continue;
      distances[other] = distances[node] + 1;
      queue.push(other);
    }
  }
  return distances;
}

const stepsToSeed = ({ parents }: Cells, node: number): number =>
  parents[node] === NONE ? 0 : 1 + stepsToSeed({ parents } as Cells, parents[node]);

describe('clusterNodes', () => {
  test.each([1, 2, 5])('with %d rings, each node joins the nearest seed, and seeds lie farther apart', (rings) => {
    const graph = strip(16, 20);
    const cells = finish(clusterNodes(graph, rings));
    const distances = distancesFrom(graph, cells.seeds);
    expect(Math.max(...distances)).toBeLessThanOrEqual(rings);
    for (const [node, distance] of distances.entries()) expect(stepsToSeed(cells, node)).toBe(distance);
    for (const seed of cells.seeds) {
      const others = distancesFrom(
        graph,
        cells.seeds.filter((other) => other !== seed),
      );
      expect(others[seed]).toBeGreaterThan(rings);
    }
  });

  test('cells are connected: the parent entry of each node leads to it from a node of the same cell', () => {
    const graph = strip(16, 20);
    const { ofNode, order, parents, parentEntries, seeds } = finish(clusterNodes(graph, 2));
    expect(order.toSorted()).toEqual(Uint32Array.from(order.keys()));
    const places = new Uint32Array(order.length);
    for (const [place, node] of order.entries()) places[node] = place;
    for (const [node, parent] of parents.entries()) {
      if (parent === NONE) {
        expect(seeds[ofNode[node]]).toBe(node);
        continue;
      }
      expect(ofNode[parent]).toBe(ofNode[node]);
      expect(places[parent]).toBeLessThan(places[node]);
      expect(graph.neighbours[parentEntries[node]]).toBe(node);
      expect(parentEntries[node]).toBeGreaterThanOrEqual(graph.starts[parent]);
      expect(parentEntries[node]).toBeLessThan(graph.starts[parent + 1]);
    }
  });

  test('no cell grows across a wall', () => {
    const graph = path(6);
    const isWall = new Uint8Array(graph.neighbours.length);
    for (let node = 0; node < 6; node++) {
      for (let entry = graph.starts[node]; entry < graph.starts[node + 1]; entry++) {
        if (node + graph.neighbours[entry] === 5) isWall[entry] = 1;
      }
    }
    const { count, ofNode } = finish(clusterNodes(graph, 9, isWall));
    expect(count).toBe(2);
    expect([...ofNode]).toEqual([0, 0, 0, 1, 1, 1]);
  });

  test('a node without neighbours is a cell', () => {
    expect([...finish(clusterNodes(graphOf(3, []), 3)).ofNode]).toEqual([0, 1, 2]);
  });

  test('a row of 100,000 nodes takes linear time', () => {
    const { count } = finish(clusterNodes(path(100_000), 99));
    expect(count).toBe(1000);
  });
});

describe('coarsen', () => {
  test('cells are neighbours, once, if nodes of theirs are', () => {
    const graph = strip(12, 20);
    const cells = finish(clusterNodes(graph, 1));
    const coarse = finish(coarsen(graph, cells));
    const expected = Array.from({ length: cells.count }, () => new Set<number>());
    for (const [node, cell] of cells.ofNode.entries()) {
      for (const other of graph.neighbours.subarray(graph.starts[node], graph.starts[node + 1])) {
        if (cells.ofNode[other] !== cell) expected[cell].add(cells.ofNode[other]);
      }
    }
    for (const [cell, others] of expected.entries()) {
      const row = coarse.neighbours.subarray(coarse.starts[cell], coarse.starts[cell + 1]);
      expect(row.toSorted()).toEqual(Uint32Array.from(others).toSorted());
    }
  });

  test('each fine entry maps to the coarse entry between its cells, and to NONE within a cell', () => {
    const graph = strip(12, 20);
    const cells = finish(clusterNodes(graph, 1));
    const coarse = finish(coarsen(graph, cells));
    for (const [node, cell] of cells.ofNode.entries()) {
      for (let entry = graph.starts[node]; entry < graph.starts[node + 1]; entry++) {
        const other = cells.ofNode[graph.neighbours[entry]];
        const to = coarse.ofEntry[entry];
        if (other === cell) expect(to).toBe(NONE);
        else {
          expect(coarse.neighbours[to]).toBe(other);
          expect(to >= coarse.starts[cell] && to < coarse.starts[cell + 1]).toBe(true);
        }
      }
    }
  });
});
