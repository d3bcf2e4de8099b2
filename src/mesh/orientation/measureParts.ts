import type { TriangleMesh } from '../TriangleMesh.js';
import { NO_PATCH, type Patches } from './consistentPatches.js';

/** A patch with what decides which way it faces. */
export interface Part {
  isClosed: boolean;
  /** The corners of its bounding box. */
  least: number[];
  most: number[];
  /** Six times the volume that a closed patch encloses, negative if it faces inward; of an open one 0. */
  volume: number;
  doubleArea: number;
  /** Some of its triangles, spread over it. */
  samples: number[];
}

/** The greatest number of samples of a patch. */
const SAMPLES = 8;

/** Measures the patches of a mesh. */
export function measureParts(
  { positions, indices }: TriangleMesh,
  areaNormals: Float64Array,
  patches: Patches,
): Part[] {
  const { patchOf, turned, isClosed, doubleAreas } = patches;
  const counts = new Uint32Array(isClosed.length);
  for (const patch of patchOf) if (patch !== NO_PATCH) counts[patch]++;
  const parts = isClosed.map(
    (isWhole, i): Part => ({
      isClosed: isWhole,
      least: [Infinity, Infinity, Infinity],
      most: [-Infinity, -Infinity, -Infinity],
      volume: 0,
      doubleArea: doubleAreas[i],
      samples: [],
    }),
  );
  /** The first vertex of each patch, by its place in `positions`. */
  const apexes = new Int32Array(isClosed.length).fill(-1);
  const seen = new Uint32Array(isClosed.length);
  for (let triangle = 0; triangle < patchOf.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch === NO_PATCH) continue;
    const { least, most, samples } = parts[patch];
    const a = 3 * indices[3 * triangle];
    const b = 3 * indices[3 * triangle + 1];
    const c = 3 * indices[3 * triangle + 2];
    for (let k = 0; k < 3; k++) {
      least[k] = Math.min(least[k], positions[a + k], positions[b + k], positions[c + k]);
      most[k] = Math.max(most[k], positions[a + k], positions[b + k], positions[c + k]);
    }
    if (seen[patch]++ * SAMPLES >= samples.length * counts[patch]) samples.push(triangle);
    if (!isClosed[patch]) continue;
    if (apexes[patch] < 0) apexes[patch] = a;
    // Measured from a vertex of the patch, since far from the origin the sum would lose its digits.
    let pyramid = 0;
    for (let k = 0; k < 3; k++)
      pyramid += (positions[a + k] - positions[apexes[patch] + k]) * areaNormals[3 * triangle + k];
    parts[patch].volume += turned[triangle] ? -pyramid : pyramid;
  }
  return parts;
}
