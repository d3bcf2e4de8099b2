import type { DrawnScene } from '../DrawnScene.js';
import type { TaskSet } from '../../worker/TaskSet.js';
import type { lineTasks } from './lineTasks.js';

/** The drawing of lines, for `runTaskOf`. */
export const lineDrawing: TaskSet<typeof lineTasks> = {
  fetchTasks: async () => (await import('./lineTasks.js')).lineTasks,
  requestBuffers: { drawLines: ({ scene }) => buffersOf(scene) },
  fetchWorker: async () => (await import('./inlineSvgWorker.js')).createInlineSvgWorker,
};

/** The large arrays of a scene, which are its own. */
function buffersOf({ corners, sides, surfaces, stippled, outlines }: DrawnScene): ArrayBuffer[] {
  const arrays = [
    ...[corners, sides],
    ...[...surfaces, ...stippled].flatMap(({ surface: { vertices, placeOf, triangles, parents } }) => [
      ...[vertices, placeOf, triangles, parents],
    ]),
    ...outlines.flatMap(({ mesh: { positions, normals, anchors, curvatures, triangles, placeOf } }) => [
      ...[positions, normals, anchors, curvatures, triangles, placeOf],
    ]),
  ];
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}
