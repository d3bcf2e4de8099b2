import type { BakingTasks } from './tasks.js';

/** The inlined workers, each with what its tasks need: most pages bake geometries, and need no more. */
const FETCH = {
  geometry: async () => (await import('./kinds/inlineGeometryWorker.js')).createInlineGeometryWorker,
  map: async () => (await import('./kinds/inlineMapWorker.js')).createInlineMapWorker,
  scene: async () => (await import('./kinds/inlineSceneWorker.js')).createInlineSceneWorker,
};

const OF_TASKS: Readonly<Partial<Record<keyof BakingTasks, keyof typeof FETCH>>> = {
  generateHatchImages: 'map',
  generateThresholds: 'map',
  completeHatchImages: 'map',
  simplifyHatched: 'scene',
  startOcclusion: 'scene',
  addDirections: 'scene',
  orientChecked: 'scene',
};

/**
 * Fetches the function that creates the inlined worker for a task. Pages that are about to bake call it before they have fetched the
 * code that does.
 */
export const fetchWorker = (task: keyof BakingTasks): Promise<() => Worker> => FETCH[OF_TASKS[task] ?? 'geometry']();
