import type { handTasks } from './handTasks.js';
import type { TaskSet } from './TaskSet.js';

/** The tasks for hands, for `runTaskOf`. */
export const handTaskSet: TaskSet<typeof handTasks> = {
  fetchTasks: async () => (await import('./handTasks.js')).handTasks,
  requestBuffers: {
    learnHand: () => [],
    traceStrokes: ({ image }) => [image.data.buffer as ArrayBuffer],
  },
  fetchWorker: async () => (await import('./inlineHandWorker.js')).createInlineHandWorker,
};
