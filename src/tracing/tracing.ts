import type { TaskSet } from '../worker/TaskSet.js';
import type { scanTasks } from './scanTasks.js';

/** The tracing of strokes, for `runTaskOf`. */
export const tracing: TaskSet<typeof scanTasks> = {
  fetchTasks: async () => (await import('./scanTasks.js')).scanTasks,
  requestBuffers: { traceStrokes: ({ image }) => [image.data.buffer as ArrayBuffer] },
  fetchWorker: async () => (await import('./inlineScanWorker.js')).createInlineScanWorker,
};
