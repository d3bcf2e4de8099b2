import { totalmem } from 'node:os';
import { loadSimplifier, simplifierOf } from '../../mesh/detail/loadSimplifier.js';
import { ModelError } from '../../viewer/files/common/ModelError.js';
import { triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import type { ReadMesh } from '../../viewer/files/readModel.js';
import { simplifyMesh } from '../../viewer/files/repair/simplifyMesh.js';

/**
 * Bytes per triangle until its lines are written, with form lines and dark hollows. Measured on scans of one and of three million
 * triangles.
 */
const BYTES_PER_TRIANGLE = 1300;
/** The share of the memory that a model may use. */
const SHARE = 0.75;
/** The module of meshoptimizer's simplifier, an optional peer dependency. */
const SIMPLIFIER = 'meshoptimizer/simplifier';

/** The number of triangles that can be drawn, rounded down. @param bytes of memory */
export const mostTriangles = (bytes: number): number => Math.floor((SHARE * bytes) / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** The bytes of memory available to this process: the machine's, or its container's limit. */
export function memoryHere(): number {
  // Node 18 does not know limits of containers, and other versions return 0 where there is none.
  return Math.min(totalmem(), process.constrainedMemory?.() || Infinity);
}

/**
 * Simplifies a model that has more triangles than `most`, and adds a note that says so.
 *
 * @param onProgress called with rising numbers in [0, 1]
 * @param simplifier the module of meshoptimizer's simplifier
 * @throws ModelError if it has too many triangles and cannot be simplified
 */
export async function fitMemory(
  model: ReadMesh,
  most: number,
  onProgress: (progress: number) => void,
  simplifier = SIMPLIFIER,
): Promise<ReadMesh> {
  const triangles = triangleCount(model.mesh);
  if (triangles <= most) return model;
  const [all, enough] = [triangles, most].map((count) => count.toLocaleString('en'));
  const tooLarge = `It has ${all} triangles, and the memory here is enough for ${enough}.`;
  if (model.mesh.uvs) throw new ModelError(`${tooLarge} Models with pictures are not simplified.`);
  try {
    await loadSimplifier(simplifier);
  } catch {
    throw new ModelError(
      `${tooLarge} With meshoptimizer beside three-hatching it is simplified: npm install meshoptimizer.`,
    );
  }
  const { mesh, error } = simplifyMesh(model.mesh, simplifierOf(simplifier), onProgress, most);
  const [drawn, share] = [triangleCount(mesh).toLocaleString('en'), (100 * error).toFixed(2)];
  return {
    ...model,
    mesh,
    simplified: { triangles, error },
    notes: [
      ...model.notes,
      `${drawn} of ${all} triangles are drawn, for which there is memory: within ${share} % of the radius from all of them`,
    ],
  };
}
