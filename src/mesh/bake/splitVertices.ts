import { isDegenerate } from '../computeAreaNormals.js';
import { hashWords } from '../hashWords.js';
import type { Fans } from '../normals/fans.js';
import { chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** The corner of a vertex that no triangle uses. */
export const NO_CORNER = 0xffffffff;

/** The result of `splitVertices`. */
export interface VertexSplit {
  /** The vertex of each corner. Added vertices follow those of the mesh. */
  indices: Uint32Array<ArrayBuffer>;
  /** For each added vertex, the vertex that it is a copy of. */
  addedVertices: Uint32Array<ArrayBuffer>;
  /** For each vertex, added ones included, a corner that uses it, or NO_CORNER. All corners that use it belong to one fan and one part. */
  cornerOfVertex: Uint32Array<ArrayBuffer>;
}

/**
 * Copies the vertices that lie in several fans, or in several parts of a second division: one copy for each pair of fan and part but the
 * first. Degenerate triangles draw nothing, so they keep their vertices and do not count.
 *
 * Few vertices need copies, which are kept in a hash table (open addressing, load of at most one half).
 *
 * @param partOf the part of each corner in the second division; by default there is none
 */
export function* splitVertices(
  mesh: TriangleMesh,
  areaNormals: Float64Array,
  { ofCorner }: Fans,
  partOf: Uint32Array = ofCorner,
): Generator<number, VertexSplit, void> {
  const vertexCount = mesh.positions.length / 3;
  const indices = mesh.indices.slice();
  const firstCorners = new Uint32Array(vertexCount).fill(NO_CORNER);
  const divisions: Divisions = { ofCorner, partOf };
  const conflicts: number[] = [];
  const degenerate: number[] = [];
  yield* chunkPhase(indices.length / 3, 0, 0.8, (start, end) =>
    findConflicts(indices, areaNormals, divisions, firstCorners, conflicts, degenerate, start, end),
  );
  for (const corner of degenerate) {
    if (firstCorners[indices[corner]] === NO_CORNER) firstCorners[indices[corner]] = corner;
  }
  let size = 16;
  while (size < 2 * conflicts.length) size *= 2;
  const copies: Copies = { table: new Uint32Array(size), corners: new Uint32Array(conflicts.length), count: 0 };
  yield* chunkPhase(conflicts.length, 0.8, 1, (start, end) =>
    splitRange(mesh.indices, indices, divisions, vertexCount, copies, conflicts, start, end),
  );
  const corners = copies.corners.subarray(0, copies.count);
  const cornerOfVertex = new Uint32Array(vertexCount + copies.count);
  cornerOfVertex.set(firstCorners);
  cornerOfVertex.set(corners, vertexCount);
  return { indices, addedVertices: corners.map((corner) => mesh.indices[corner]), cornerOfVertex };
}

/** Two divisions of corners: the fan of each corner, and its part. */
interface Divisions {
  ofCorner: Uint32Array;
  partOf: Uint32Array;
}

const isSame = ({ ofCorner, partOf }: Divisions, a: number, b: number): boolean =>
  ofCorner[a] === ofCorner[b] && partOf[a] === partOf[b];

/** The copies of vertices, as a hash table. */
interface Copies {
  /** Indices into `corners` + 1; 0 is an empty slot. */
  table: Uint32Array;
  /** The first corner of each copy. */
  corners: Uint32Array<ArrayBuffer>;
  count: number;
}

/**
 * Finds the first corner of each vertex, and the corners that need a copy of their vertex because it belongs to another fan or part.
 * Corners of degenerate triangles are collected instead: they count only where a vertex has no others.
 */
function findConflicts(
  indices: Uint32Array,
  areaNormals: Float64Array,
  divisions: Divisions,
  firstCorners: Uint32Array,
  conflicts: number[],
  degenerate: number[],
  start: number,
  end: number,
): void {
  for (let triangle = start; triangle < end; triangle++) {
    const isFlat = isDegenerate(areaNormals, triangle);
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const first = firstCorners[indices[corner]];
      if (isFlat) degenerate.push(corner);
      else if (first === NO_CORNER) firstCorners[indices[corner]] = corner;
      else if (!isSame(divisions, first, corner)) conflicts.push(corner);
    }
  }
}

/** Gives copies to a range of the corners that need one. */
function splitRange(
  vertices: Uint32Array,
  indices: Uint32Array,
  divisions: Divisions,
  vertexCount: number,
  copies: Copies,
  conflicts: readonly number[],
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    indices[conflicts[i]] = vertexCount + copyFor(vertices, divisions, copies, conflicts[i]);
  }
}

/** The number of the copy of the corner's vertex for the corner's fan and part. The copy is made if it does not exist yet. */
function copyFor(vertices: Uint32Array, divisions: Divisions, copies: Copies, corner: number): number {
  const { table, corners } = copies;
  const mask = table.length - 1;
  const vertex = vertices[corner];
  const { ofCorner, partOf } = divisions;
  for (let slot = hashWords(vertex, ofCorner[corner], partOf[corner]) & mask; ; slot = (slot + 1) & mask) {
    const copy = table[slot] - 1;
    if (copy < 0) {
      corners[copies.count] = corner;
      table[slot] = copies.count + 1;
      return copies.count++;
    }
    const other = corners[copy];
    if (vertices[other] === vertex && isSame(divisions, other, corner)) return copy;
  }
}
