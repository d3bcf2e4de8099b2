import { type PlainMesh, triangleCount } from './PlainMesh.js';

/** Meshes with fewer triangles bake so fast that a placeholder would only flicker. */
const LEAST_TRIANGLES = 100_000;
/** Meshes with more triangles are slow to light, upload and draw; a coarse copy is their placeholder. */
const MOST_TRIANGLES = 400_000;

/**
 * Whether a mesh needs a coarse copy as placeholder until it is baked. Meshes with pictures, which are decoded once, or with glass have
 * none.
 */
export const needsCoarse = (mesh: PlainMesh): boolean => !mesh.ranges && triangleCount(mesh) > MOST_TRIANGLES;

/**
 * The normals of {@link meanNormals}; null for a mesh that is not its own placeholder: a small or a large one, or one with pictures or
 * glass.
 */
export function plainNormals(mesh: PlainMesh): Float32Array | null {
  const isSmall = triangleCount(mesh) < LEAST_TRIANGLES;
  return isSmall || mesh.ranges || needsCoarse(mesh) ? null : meanNormals(mesh);
}

/** Normals for drawing a mesh until it is baked: its own, or area-weighted vertex normals where it has none. */
export function meanNormals({ positions, normals, indices }: PlainMesh): Float32Array {
  const cornerCount = indices?.length ?? positions.length / 3;
  if (normals && areAllSet(normals)) return normals;
  const sums = new Float32Array(positions.length);
  for (let corner = 0; corner + 2 < cornerCount; corner += 3) {
    const a = 3 * (indices ? indices[corner] : corner);
    const b = 3 * (indices ? indices[corner + 1] : corner + 1);
    const c = 3 * (indices ? indices[corner + 2] : corner + 2);
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    sums[a] += x;
    sums[a + 1] += y;
    sums[a + 2] += z;
    sums[b] += x;
    sums[b + 1] += y;
    sums[b + 2] += z;
    sums[c] += x;
    sums[c + 1] += y;
    sums[c + 2] += z;
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
