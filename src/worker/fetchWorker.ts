import type { contourTasks } from './kinds/contourTasks.js';
import type { geometryTasks } from './kinds/geometryTasks.js';
import type { indexedTasks } from './kinds/indexedTasks.js';
import type { mapTasks } from './kinds/mapTasks.js';
import type { sceneTasks } from './kinds/sceneTasks.js';
import type { BakingTasks } from './tasks.js';

/** The inlined workers, each with what its tasks need: most pages bake geometries without adjacency, and need no more. */
const FETCH = {
  indexed: async () => (await import('./kinds/inlineIndexedWorker.js')).createInlineIndexedWorker,
  geometry: async () => (await import('./kinds/inlineGeometryWorker.js')).createInlineGeometryWorker,
  contour: async () => (await import('./kinds/inlineContourWorker.js')).createInlineContourWorker,
  map: async () => (await import('./kinds/inlineMapWorker.js')).createInlineMapWorker,
  scene: async () => (await import('./kinds/inlineSceneWorker.js')).createInlineSceneWorker,
};

type OfTasks<Tasks, Kind extends keyof typeof FETCH> = Readonly<Record<keyof Tasks, Kind>>;

/** The worker that does each task. */
const OF_TASKS: OfTasks<typeof indexedTasks, 'indexed'> &
  OfTasks<typeof geometryTasks, 'geometry'> &
  OfTasks<typeof contourTasks, 'contour'> &
  OfTasks<typeof mapTasks, 'map'> &
  OfTasks<typeof sceneTasks, 'scene'> = {
  bakeIndexed: 'indexed',
  bakeCorners: 'geometry',
  bakeJointForms: 'geometry',
  bakePull: 'geometry',
  searchContours: 'contour',
  generateHatchImages: 'map',
  generateThresholds: 'map',
  completeHatchImages: 'map',
  simplifyHatched: 'scene',
  startOcclusion: 'scene',
  addDirections: 'scene',
  orientChecked: 'scene',
  lineSpacings: 'scene',
  intersectOutlines: 'scene',
};

/**
 * Fetches the function that creates the inlined worker for a task. Pages that are about to bake call it before they have fetched the
 * code that does.
 */
export const fetchWorker = (task: keyof BakingTasks): Promise<() => Worker> => FETCH[OF_TASKS[task]]();
