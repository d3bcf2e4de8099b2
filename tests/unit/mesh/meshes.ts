import type { TriangleMesh } from '../../../src/mesh/TriangleMesh.js';

/** Runs a computation to its end at once. */
export function finish<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}

/** A mesh from vertices and triangles, each a row. */
export const meshOf = (
  vertices: readonly (readonly number[])[],
  triangles: readonly (readonly number[])[],
): TriangleMesh => ({
  positions: new Float32Array(vertices.flat()),
  indices: new Uint32Array(triangles.flat()),
});

/** Rows of three, for tables that are read by triangle. */
export const byTriangle = (values: Iterable<number>): number[][] => {
  const rows: number[][] = [];
  for (const value of values) {
    if (rows.length === 0 || rows.at(-1)!.length === 3) rows.push([]);
    rows.at(-1)!.push(value);
  }
  return rows;
};

/** `count` triangles around vertex 0, closed. */
export function fan(count: number): TriangleMesh {
  const positions = new Float32Array(3 * (count + 1));
  const indices = new Uint32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const angle = (2 * Math.PI * i) / count;
    positions.set([Math.cos(angle), Math.sin(angle), 0], 3 * (i + 1));
    indices.set([0, i + 1, ((i + 1) % count) + 1], 3 * i);
  }
  return { positions, indices };
}

/** `count` triangles on the one edge 0–1, like the pages of a book, every second one wound the other way. */
export function book(count: number): TriangleMesh {
  const positions = new Float32Array(3 * (count + 2));
  positions.set([0, 0, 1], 3);
  const indices = new Uint32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const angle = (2 * Math.PI * i) / count;
    positions.set([Math.cos(angle), Math.sin(angle), 0], 3 * (i + 2));
    indices.set(i % 2 ? [0, 1, i + 2] : [1, 0, i + 2], 3 * i);
  }
  return { positions, indices };
}
