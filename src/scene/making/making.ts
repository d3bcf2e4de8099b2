import type { Material, Texture } from 'three';
import { failure } from '../chooseMeshes.js';
import type { OldLook, PlannedMesh } from '../geometryPlans.js';
import type { SkippedMesh } from '../HatchedScene.js';
import type { MaterialReplacer } from '../MaterialReplacer.js';
import { worldMatrices, worldScale } from '../worldMatrices.js';

/** The code that makes materials, geometries and maps. It is fetched when a scene is hatched; pages need nothing of it before. */
export { geometryPlans } from '../geometryPlans.js';
export { MaterialReplacer } from '../MaterialReplacer.js';
export { bakeGeometries, progressParts } from './bakeGeometries.js';
export { makeMaps } from './makeMaps.js';

/**
 * Runs jobs concurrently, and resolves with their results. If one fails, the others are aborted, and once all have ended the promise is
 * rejected with the first error.
 *
 * @param signal aborts all jobs
 * @param jobs are started in this order, each with a signal that aborts it
 */
export async function sideBySide<Results extends unknown[]>(
  signal: AbortSignal | undefined,
  ...jobs: { [Index in keyof Results]: (signal: AbortSignal) => Promise<Results[Index]> }
): Promise<Results> {
  const stop = new AbortController();
  const abort = (): void => stop.abort(signal?.reason);
  signal?.addEventListener('abort', abort);
  if (signal?.aborted) abort();
  try {
    const running = jobs.map((job) =>
      job(stop.signal).catch((error: unknown) => {
        // Only the first reason counts; later calls of abort() have no effect.
        stop.abort(error);
      }),
    );
    const results = await Promise.all(running);
    stop.signal.throwIfAborted();
    return results as Results;
  } finally {
    signal?.removeEventListener('abort', abort);
  }
}

/** Makes the new materials of meshes. It yields after each mesh, since a scene may have thousands of materials. */
export function* planMeshes(
  looks: readonly OldLook[],
  replacer: MaterialReplacer,
): Generator<number, PlannedMesh[], void> {
  const planned: PlannedMesh[] = [];
  for (const look of looks) {
    const scale = worldScale(worldMatrices(look.mesh));
    planned.push({ ...look, material: replacer.replacementFor(look.mesh, look.oldMaterial, scale) });
    yield planned.length / looks.length;
  }
  return planned;
}

/**
 * Sets a displaced geometry, to be baked, on looks whose materials have a displacement map. Scenes without such materials do not load
 * the code for it.
 *
 * @param unreadable receives the meshes that cannot be displaced
 */
export async function displaceMeshes(
  looks: readonly OldLook[],
  unreadable: SkippedMesh[],
): Promise<readonly OldLook[]> {
  if (!looks.some(isDisplaced)) return looks;
  const { Displacer } = await import('../Displacer.js');
  const displacer = new Displacer();
  return looks.flatMap((look) => {
    if (!isDisplaced(look)) return [look];
    try {
      return [{ ...look, geometry: displacer.displaced(look), flatGeometry: look.geometry }];
    } catch (error) {
      unreadable.push(failure(look.mesh, error as Error));
      return [];
    }
  });
}

const isDisplaced = ({ oldMaterial }: OldLook): boolean =>
  [oldMaterial].flat().some((material: Displaceable | null | undefined) => material?.displacementMap);

type Displaceable = Material & { displacementMap?: Texture | null };
