import { orientTriangles } from '../../../mesh/orientation/orientTriangles.js';
import { normalsToTurn, turnTriangles } from '../../../mesh/orientation/turnTriangles.js';
import { runToEnd } from '../../../mesh/phases.js';
import type { PlainMesh } from './PlainMesh.js';

/** Runs a task that yields its progress in [0, 1] to its end at once. */
type Run = <Result>(task: Generator<number, Result, void>) => Result;

/**
 * Turns the triangles that face the wrong way, in copies of the arrays that change, and with them the normals that point to the side that
 * is the back now. A vertex that a turned and another triangle share becomes two.
 *
 * @param run finds them, and may report how far that is
 * @returns the mesh, and the number of triangles that were turned
 */
export function orientMesh(mesh: PlainMesh, run: Run = runToEnd): { mesh: PlainMesh; turned: number } {
  const indices = mesh.indices
    ? new Uint32Array(mesh.indices)
    : Uint32Array.from({ length: mesh.positions.length / 3 }, (_, i) => i);
  const isTurned = run(orientTriangles({ positions: new Float32Array(mesh.positions), indices }));
  const turned = isTurned.reduce((sum, one) => sum + one, 0);
  if (turned === 0) return { mesh, turned };
  const copies = turnTriangles(indices, isTurned, mesh.positions.length / 3);
  const positions = withCopies(mesh.positions, copies, 3);
  const normals = mesh.normals && withCopies(mesh.normals, copies, 3);
  if (normals) {
    const vertices = normalsToTurn({ positions, indices }, isTurned, (vertex, normal) => {
      for (let k = 0; k < 3; k++) normal[k] = normals[3 * vertex + k];
    });
    for (const vertex of vertices) for (let k = 0; k < 3; k++) normals[3 * vertex + k] *= -1;
  }
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

type Owned<Values> = Values extends Float32Array ? Float32Array<ArrayBuffer> : Uint32Array<ArrayBuffer>;

function withCopies<Values extends Float32Array | Uint32Array>(
  values: Values,
  copies: Uint32Array,
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
