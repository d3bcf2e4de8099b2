import { BufferAttribute, type BufferGeometry, Mesh, type Object3D, Vector3 } from 'three';
import { orientTriangles } from '../../../mesh/orientation/orientTriangles.js';
import { normalsToTurn, turnTriangles } from '../../../mesh/orientation/turnTriangles.js';
import { runToEnd } from '../../../mesh/phases.js';
import type { TriangleMesh } from '../../../mesh/TriangleMesh.js';

/** A mesh in its place, with its share of the triangles of the scene. */
interface Placed {
  mesh: Mesh;
  positions: Float32Array;
  indices: Uint32Array;
}

/**
 * Turns the triangles of a scene that face the wrong way at rest, in its geometries. A geometry of several meshes is turned as the first of
 * them needs it; damaged ones and instances are left.
 *
 * @returns the number of triangles that were turned
 */
export function orientScene(root: Object3D): number {
  root.updateMatrixWorld(true);
  const parts = new Map<BufferGeometry, Placed>();
  root.traverseVisible((object) => {
    if (!(object instanceof Mesh) || 'isInstancedMesh' in object || parts.has(object.geometry)) return;
    const placed = placedMesh(object);
    if (placed) parts.set(object.geometry, placed);
  });
  const all = [...parts.values()];
  const isTurned = runToEnd(orientTriangles(joined(all)));
  let first = 0;
  let turned = 0;
  for (const { mesh, indices } of all) {
    const own = isTurned.subarray(first, first + indices.length / 3);
    first += own.length;
    const count = own.reduce((sum, one) => sum + one, 0);
    if (count > 0) turnGeometry(mesh.geometry, own);
    turned += count;
  }
  return turned;
}

/** The triangles of a mesh in the scene; undefined if they cannot be oriented. A mirroring matrix reverses them. */
function placedMesh(mesh: Mesh): Placed | undefined {
  const { index, attributes } = mesh.geometry as BufferGeometry;
  const count = attributes.position?.count ?? 0;
  const corners = index?.count ?? count;
  if (corners === 0 || corners % 3 !== 0) return undefined;
  const positions = new Float32Array(3 * count);
  const point = new Vector3();
  for (let vertex = 0; vertex < count; vertex++)
    mesh
      .getVertexPosition(vertex, point)
      .applyMatrix4(mesh.matrixWorld)
      .toArray(positions, 3 * vertex);
  const order = mesh.matrixWorld.determinant() < 0 ? [0, 2, 1] : [0, 1, 2];
  const indices = Uint32Array.from({ length: corners }, (_, corner) => {
    const at = corner - (corner % 3) + order[corner % 3];
    return index ? index.getX(at) : at;
  });
  const isWhole = positions.every(Number.isFinite) && indices.every((vertex) => vertex < count);
  return isWhole ? { mesh, positions, indices } : undefined;
}

function joined(parts: readonly Placed[]): TriangleMesh {
  const positions = new Float32Array(parts.reduce((sum, part) => sum + part.positions.length, 0));
  const indices = new Uint32Array(parts.reduce((sum, part) => sum + part.indices.length, 0));
  let vertex = 0;
  let corner = 0;
  for (const part of parts) {
    positions.set(part.positions, 3 * vertex);
    for (const one of part.indices) indices[corner++] = vertex + one;
    vertex += part.positions.length / 3;
  }
  return { positions, indices };
}

/** Turns triangles of a geometry, with their normals. */
function turnGeometry(geometry: BufferGeometry, isTurned: Uint8Array): void {
  const { index, attributes, morphAttributes } = geometry;
  const { count } = attributes.position;
  const indices = Uint32Array.from({ length: index?.count ?? count }, (_, corner) =>
    index ? index.getX(corner) : corner,
  );
  const copies = turnTriangles(indices, isTurned, count);
  geometry.setIndex(new BufferAttribute(indices, 1));
  for (const [name, attribute] of Object.entries(attributes))
    geometry.setAttribute(name, withCopies(attribute as BufferAttribute, copies));
  for (const targets of Object.values(morphAttributes))
    for (const [i, target] of targets.entries()) targets[i] = withCopies(target as BufferAttribute, copies);
  const { position, normal } = geometry.attributes;
  if (!normal) return;
  const positions = Float32Array.from({ length: 3 * position.count }, (_, i) =>
    position.getComponent(Math.floor(i / 3), i % 3),
  );
  const vertices = normalsToTurn({ positions, indices }, isTurned, (vertex, value) => {
    for (let k = 0; k < 3; k++) value[k] = normal.getComponent(vertex, k);
  });
  for (const attribute of [normal, ...(geometry.morphAttributes.normal ?? [])])
    for (const vertex of vertices)
      for (let k = 0; k < 3; k++) attribute.setComponent(vertex, k, -attribute.getComponent(vertex, k));
}

/** A copy of an attribute, with copies of some entries at its end. */
function withCopies(attribute: BufferAttribute, copies: Uint32Array): BufferAttribute {
  const { array, itemSize, normalized, count } = attribute.clone();
  const Type = array.constructor as new (length: number) => Float32Array;
  const values = new Type((count + copies.length) * itemSize);
  values.set(array);
  for (const [i, vertex] of copies.entries())
    values.set(array.subarray(itemSize * vertex, itemSize * (vertex + 1)), itemSize * (count + i));
  return new BufferAttribute(values, itemSize, normalized);
}
