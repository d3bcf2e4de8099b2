import { computeAreaNormals } from '../../../mesh/computeAreaNormals.js';
import { orientTriangles } from '../../../mesh/orientation/orientTriangles.js';
import { runToEnd } from '../../../mesh/phases.js';
import type { TriangleMesh } from '../../../mesh/TriangleMesh.js';
import type { PlainMesh } from './PlainMesh.js';

/**
 * Turns the triangles that face the wrong way, in place or in a copy of the arrays that change, and with them the normals that point to
 * the side that is the back now. A vertex that a turned and another triangle share becomes two.
 *
 * @returns the mesh, and the number of triangles that were turned
 */
export function orientMesh(mesh: PlainMesh): { mesh: PlainMesh; turned: number } {
  const indices = mesh.indices
    ? new Uint32Array(mesh.indices)
    : Uint32Array.from({ length: mesh.positions.length / 3 }, (_, i) => i);
  const isTurned = runToEnd(orientTriangles({ positions: new Float32Array(mesh.positions), indices }));
  const turned = isTurned.reduce((sum, one) => sum + one, 0);
  if (turned === 0) return { mesh, turned };
  const copies = shareNoVertices(indices, isTurned, mesh.positions.length / 3);
  for (let triangle = 0; triangle < isTurned.length; triangle++) {
    if (!isTurned[triangle]) continue;
    const corner = 3 * triangle;
    [indices[corner + 1], indices[corner + 2]] = [indices[corner + 2], indices[corner + 1]];
  }
  const positions = withCopies(mesh.positions, copies, 3);
  const normals = mesh.normals && withCopies(mesh.normals, copies, 3);
  if (normals) turnNormals({ positions, indices }, normals, isTurned);
  return {
    mesh: {
      ...mesh,
      positions,
      normals,
      colors: mesh.colors && withCopies(mesh.colors, copies, 3),
      ...(mesh.uvs && { uvs: withCopies(mesh.uvs, copies, 2) }),
      ...(mesh.parts && { parts: { ...mesh.parts, ofVertices: withCopies(mesh.parts.ofVertices, copies, 1) } }),
      indices,
    },
    turned,
  };
}

/** Gives turned triangles vertices of their own where they share some with others. @returns the vertices that get a copy, in order */
function shareNoVertices(indices: Uint32Array, isTurned: Uint8Array, vertexCount: number): number[] {
  const isKept = new Uint8Array(vertexCount);
  for (let corner = 0; corner < indices.length; corner++) {
    if (!isTurned[Math.floor(corner / 3)]) isKept[indices[corner]] = 1;
  }
  const copies: number[] = [];
  const copyOf = new Map<number, number>();
  for (let corner = 0; corner < indices.length; corner++) {
    const vertex = indices[corner];
    if (!isTurned[Math.floor(corner / 3)] || !isKept[vertex]) continue;
    let copy = copyOf.get(vertex);
    if (copy === undefined) {
      copy = vertexCount + copies.push(vertex) - 1;
      copyOf.set(vertex, copy);
    }
    indices[corner] = copy;
  }
  return copies;
}

type Owned<Values> = Values extends Float32Array ? Float32Array<ArrayBuffer> : Uint32Array<ArrayBuffer>;

function withCopies<Values extends Float32Array | Uint32Array>(
  values: Values,
  copies: readonly number[],
  size: number,
): Owned<Values> {
  const length = values.length + size * copies.length;
  const all = new (values.constructor as new (length: number) => Owned<Values>)(length);
  all.set(values);
  for (const [i, vertex] of copies.entries()) {
    all.set(values.subarray(size * vertex, size * (vertex + 1)), values.length + size * i);
  }
  return all;
}

/** Reverses the normals of turned triangles that point away from the side that is their front now. */
function turnNormals(mesh: TriangleMesh, normals: Float32Array, isTurned: Uint8Array): void {
  const areaNormals = runToEnd(computeAreaNormals(mesh));
  const sides = new Float64Array(normals.length / 3);
  for (const [corner, vertex] of mesh.indices.entries()) {
    const triangle = Math.floor(corner / 3);
    if (!isTurned[triangle]) continue;
    for (let k = 0; k < 3; k++) sides[vertex] += areaNormals[3 * triangle + k] * normals[3 * vertex + k];
  }
  for (let vertex = 0; vertex < sides.length; vertex++) {
    if (sides[vertex] < 0) for (let k = 0; k < 3; k++) normals[3 * vertex + k] *= -1;
  }
}
