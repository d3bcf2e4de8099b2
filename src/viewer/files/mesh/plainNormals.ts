import { type PlainMesh, setFaceNormal, triangleCount } from './PlainMesh.js';

/** Meshes with fewer triangles bake so fast that a placeholder would only flicker. */
const LEAST_TRIANGLES = 100_000;
/** Meshes with more triangles are slow to light, upload and draw; a coarse copy is their placeholder. */
const MOST_TRIANGLES = 400_000;

/** Whether a mesh looks the same all over, apart from its shadows. */
const isAlike = ({ ranges = [] }: PlainMesh): boolean =>
  ranges.every(
    ({ picture, isSeeThrough, isOneSided }) => picture === -1 && !isSeeThrough && isOneSided === ranges[0].isOneSided,
  );

/**
 * Whether a mesh needs a coarse copy as placeholder until it is baked. Meshes with pictures, which are decoded once, or with glass have
 * none.
 */
export const needsCoarse = (mesh: PlainMesh): boolean => isAlike(mesh) && triangleCount(mesh) > MOST_TRIANGLES;

/**
 * The normals of {@link meanNormals}; null for a mesh that is not its own placeholder: a small or a large one, or one with pictures or
 * glass.
 */
export function plainNormals(mesh: PlainMesh): Float32Array | null {
  const isSmall = triangleCount(mesh) < LEAST_TRIANGLES;
  return isSmall || !isAlike(mesh) || needsCoarse(mesh) ? null : meanNormals(mesh);
}

/** Normals for drawing a mesh until it is baked: its own, or area-weighted vertex normals where it has none. */
export function meanNormals({ positions, normals, indices }: PlainMesh): Float32Array {
  const cornerCount = indices?.length ?? positions.length / 3;
  if (normals && areAllSet(normals)) return normals;
  const sums = new Float32Array(positions.length);
  const face = new Float64Array(3);
  for (let corner = 0; corner + 2 < cornerCount; corner += 3) {
    const a = 3 * (indices ? indices[corner] : corner);
    const b = 3 * (indices ? indices[corner + 1] : corner + 1);
    const c = 3 * (indices ? indices[corner + 2] : corner + 2);
    setFaceNormal(face, positions, a, b, c);
    for (let k = 0; k < 3; k++) {
      sums[a + k] += face[k];
      sums[b + k] += face[k];
      sums[c + k] += face[k];
    }
  }
  for (let i = 0; i < sums.length; i += 3) {
    const length = Math.sqrt(sums[i] * sums[i] + sums[i + 1] * sums[i + 1] + sums[i + 2] * sums[i + 2]);
    if (length === 0) sums[i + 2] = 1;
    const scale = 1 / (length || 1);
    sums[i] *= scale;
    sums[i + 1] *= scale;
    sums[i + 2] *= scale;
  }
  // The file's own normals take precedence, as in the bake.
  if (!normals) return sums;
  for (let i = 0; i < sums.length; i += 3) {
    if (isSet(normals, i)) for (let k = i; k < i + 3; k++) sums[k] = normals[k];
  }
  return sums;
}

const isSet = (normals: Float32Array, i: number): boolean =>
  Math.abs(normals[i]) + Math.abs(normals[i + 1]) + Math.abs(normals[i + 2]) > 0;

function areAllSet(normals: Float32Array): boolean {
  for (let i = 0; i < normals.length; i += 3) if (!isSet(normals, i)) return false;
  return true;
}

/** Whether the back faces of a mesh are hidden before it is baked: by the file, or because it is closed. */
export const hidesBacks = (mesh: PlainMesh): boolean =>
  mesh.isOneSided ?? mesh.ranges?.[0].isOneSided ?? isClosed(mesh);

/**
 * Whether the triangles of a mesh form a closed surface with consistent winding: each edge occurs as often in one direction as in the
 * other. Vertices are compared by index, so a mesh with seams counts as open. Each directed edge adds a hash that its reverse cancels; an
 * open mesh sums to 0 by chance once in four billion.
 */
export function isClosed({ indices }: Pick<PlainMesh, 'indices'>): boolean {
  if (!indices) return false;
  let sum = 0;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = scatter(indices[i]);
    const b = scatter(indices[i + 1]);
    const c = scatter(indices[i + 2]);
    // Antisymmetric in the ends of the edge. A mere difference of two hashes would cancel around any triangle.
    sum = (sum + scatter(a ^ Math.imul(b, 3)) - scatter(b ^ Math.imul(a, 3))) | 0;
    sum = (sum + scatter(b ^ Math.imul(c, 3)) - scatter(c ^ Math.imul(b, 3))) | 0;
    sum = (sum + scatter(c ^ Math.imul(a, 3)) - scatter(a ^ Math.imul(c, 3))) | 0;
  }
  return sum === 0;
}

/** The finalizer of MurmurHash3 (Austin Appleby, public domain). */
function scatter(word: number): number {
  let h = Math.imul(word ^ (word >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
