/** The code that makes materials, geometries and maps. It is fetched when a scene is hatched; pages need nothing of it before. */
export { displaceMeshes } from '../displaceMeshes.js';
export { geometryPlans } from '../geometryPlans.js';
export { MaterialReplacer } from '../MaterialReplacer.js';
export { planMeshes } from '../planMeshes.js';
export { bakeGeometries } from './bakeGeometries.js';
export { makeMaps } from './makeMaps.js';
export { progressParts } from './progressParts.js';

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
