import { computeAreaNormals } from '../computeAreaNormals.js';
import { runToEnd } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/**
 * Exchanges two corners of the turned triangles, in place. A vertex that a turned and another triangle share becomes two, so that each can
 * have a normal of its own.
 *
 * @param isTurned for each triangle 1 if it is turned
 * @returns the vertices that get a copy; the copies follow the vertices of the mesh in this order
 */
export function turnTriangles(
  indices: Uint32Array,
  isTurned: Uint8Array,
  vertexCount: number,
): Uint32Array<ArrayBuffer> {
  const isKept = new Uint8Array(vertexCount);
  for (let triangle = 0; triangle < isTurned.length; triangle++) {
    if (isTurned[triangle]) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) isKept[indices[corner]] = 1;
  }
  const copies: number[] = [];
  /** For each vertex its copy, or 0. */
  const copyOf = new Uint32Array(vertexCount);
  for (let triangle = 0; triangle < isTurned.length; triangle++) {
    if (!isTurned[triangle]) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const vertex = indices[corner];
      if (!isKept[vertex]) continue;
      if (copyOf[vertex] === 0) copyOf[vertex] = vertexCount + copies.push(vertex) - 1;
      indices[corner] = copyOf[vertex];
    }
    const corner = 3 * triangle;
    [indices[corner + 1], indices[corner + 2]] = [indices[corner + 2], indices[corner + 1]];
  }
  return Uint32Array.from(copies);
}

/**
 * The vertices of turned triangles whose normal points to the back.
 *
 * @param mesh after triangles were turned
 * @param normalOf writes x, y, z of a vertex's normal
 */
export function normalsToTurn(
  mesh: TriangleMesh,
  isTurned: Uint8Array,
  normalOf: (vertex: number, normal: [number, number, number]) => void,
): number[] {
  const { positions, indices } = mesh;
  const areaNormals = runToEnd(computeAreaNormals(mesh));
  const sides = new Float64Array(positions.length / 3);
  const normal: [number, number, number] = [0, 0, 0];
  for (let triangle = 0; triangle < isTurned.length; triangle++) {
    if (!isTurned[triangle]) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      normalOf(indices[corner], normal);
      for (let k = 0; k < 3; k++) sides[indices[corner]] += areaNormals[3 * triangle + k] * normal[k];
    }
  }
  const found: number[] = [];
  for (let vertex = 0; vertex < sides.length; vertex++) if (sides[vertex] < 0) found.push(vertex);
  return found;
}
