import { ModelError } from '../common/ModelError.js';
import { type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';

/**
 * Removes faults that three's loaders pass on: triangles with a missing, infinite or NaN vertex, and unused vertices, which would spoil the
 * fit.
 *
 * @returns the mesh, and the number of triangles left out
 * @throws ModelError when nothing is left
 */
export function cleanMesh(mesh: PlainMesh): { mesh: PlainMesh; broken: number } {
  if (isClean(mesh)) return { mesh, broken: 0 };
  const { positions, indices } = mesh;
  const vertexCount = positions.length / 3;
  const total = triangleCount(mesh);
  const isValid = (vertex: number): boolean =>
    vertex < vertexCount &&
    Number.isFinite(positions[3 * vertex]) &&
    Number.isFinite(positions[3 * vertex + 1]) &&
    Number.isFinite(positions[3 * vertex + 2]);

  const kept = new Uint32Array(3 * total);
  let length = 0;
  const ranges: PictureRange[] = [];
  for (const range of mesh.ranges ?? [{ start: 0, count: 3 * total, picture: -1 }]) {
    const { start, count } = range;
    const first = length;
    for (let corner = start; corner < start + count; corner += 3) {
      const a = indices ? indices[corner] : corner;
      const b = indices ? indices[corner + 1] : corner + 1;
      const c = indices ? indices[corner + 2] : corner + 2;
      if (!(isValid(a) && isValid(b) && isValid(c))) continue;
      kept[length++] = a;
      kept[length++] = b;
      kept[length++] = c;
    }
    if (length > first) ranges.push({ ...range, start: first, count: length - first });
  }
  if (length === 0) throw new ModelError('None of the triangles in the file has three valid corners.');
  const cleaned = compact(mesh, kept.subarray(0, length));
  return { mesh: mesh.ranges ? { ...cleaned, ranges } : cleaned, broken: total - length / 3 };
}

/** Whether nothing needs to be removed, as in most files, so that nothing is copied. */
function isClean({ positions, normals, colors, uvs, indices, ranges }: PlainMesh): boolean {
  const vertexCount = positions.length / 3;
  if (!indices?.length || indices.byteLength !== indices.buffer.byteLength || indices.length % 3 || ranges)
    return false;
  const fits = (values: Float32Array | null | undefined, size: number): boolean =>
    !values || values.length === size * vertexCount;
  if (!fits(normals, 3) || !fits(colors, 3) || !fits(uvs, 2)) return false;
  for (let i = 0; i < positions.length; i++) if (!Number.isFinite(positions[i])) return false;
  const isUsed = new Uint8Array(vertexCount);
  let used = 0;
  for (let corner = 0; corner < indices.length; corner++) {
    const vertex = indices[corner];
    if (vertex >= vertexCount) return false;
    used += 1 - isUsed[vertex];
    isUsed[vertex] = 1;
  }
  return used === vertexCount;
}

/** A mesh of some triangles of another, without unused vertices. */
export function compact(mesh: PlainMesh, indices: Uint32Array): PlainMesh {
  const vertexCount = mesh.positions.length / 3;
  const renumbered = new Uint32Array(vertexCount);
  for (const vertex of indices) renumbered[vertex] = 1;
  let count = 0;
  for (let vertex = 0; vertex < vertexCount; vertex++) if (renumbered[vertex]) renumbered[vertex] = ++count;
  const pick = <Values extends Float32Array | Uint32Array>(source: Values, size: number): Values => {
    if (count === vertexCount)
      return source.length === size * vertexCount ? source : (source.slice(0, size * vertexCount) as Values);
    const picked = new (source.constructor as new (length: number) => Values)(size * count);
    for (let vertex = 0; vertex < vertexCount; vertex++) {
      const from = size * vertex;
      const to = size * (renumbered[vertex] - 1);
      if (to >= 0) for (let i = 0; i < size; i++) picked[to + i] = source[from + i];
    }
    return picked;
  };
  return {
    positions: pick(mesh.positions, 3),
    normals: mesh.normals && pick(mesh.normals, 3),
    colors: mesh.colors && pick(mesh.colors, 3),
    indices: indices.map((vertex) => renumbered[vertex] - 1),
    ...(mesh.uvs && { uvs: pick(mesh.uvs, 2) }),
    ...(mesh.isOneSided !== undefined && { isOneSided: mesh.isOneSided }),
    ...(mesh.castsFronts && { castsFronts: true }),
    ...(mesh.parts && { parts: { ...mesh.parts, ofVertices: pick(mesh.parts.ofVertices, 1) } }),
  };
}
