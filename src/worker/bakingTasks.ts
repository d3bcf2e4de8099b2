import { requestBuffers } from './requestBuffers.js';
import type { TaskSet } from './TaskSet.js';
import type { BakingTasks } from './tasks.js';

/** The tasks that bake geometry and draw the images of maps. */
export const bakingTasks: TaskSet<BakingTasks> = {
  fetchTasks: async () => (await import('./tasks.js')).tasks,
  requestBuffers,
  fetchWorker: async () => (await import('./inlineWorker.js')).createInlineWorker,
};
