import { totalmem } from 'node:os';
import { loadSimplifier, simplifierOf } from '../../mesh/detail/loadSimplifier.js';
import { ModelError } from '../../viewer/files/common/ModelError.js';
import { triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import type { ReadMesh } from '../../viewer/files/readModel.js';
import { simplifyMesh } from '../../viewer/files/repair/simplifyMesh.js';

/**
 * The memory that a triangle takes until its lines are written, along the form and with dark hollows. It was measured on scans of one and
 * of three million triangles.
 */
const BYTES_PER_TRIANGLE = 1300;
/** The share of the memory that a model may take. */
const SHARE = 0.75;
/** Where meshoptimizer's simplifier lies if it is installed beside this package, whose optional peer it is. */
const SIMPLIFIER = 'meshoptimizer/simplifier';

/** How many triangles can be drawn, as a round number. @param bytes of memory */
export const mostTriangles = (bytes: number): number => Math.floor((SHARE * bytes) / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** The bytes of memory that this process can get: those of the machine, or of a container. */
export function memoryHere(): number {
  // Node 18 does not know the limits of a container, and says 0 where there is none.
  return Math.min(totalmem(), process.constrainedMemory?.() || Infinity);
}

/**
 * A model that is drawn in the memory there is: as it is or, with more triangles than `most`, simplified. A note says so.
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
