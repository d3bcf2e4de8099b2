import { parentPort, workerData } from 'node:worker_threads';
import type { DrawMessage, DrawTask } from '../DrawThread.js';

/** The thread that draws a model. What it needs is imported when it runs, so that it can say what is not installed. */
const say = (message: DrawMessage): void => parentPort?.postMessage(message);
const task = workerData as DrawTask;

try {
  const { drawModel } = await import('./drawModel.js');
  say({ kind: 'done', isWhole: await drawModel(task, say) });
} catch (error) {
  const { failure } = await import('./failure.js');
  say({ kind: 'failed', sentence: failure(task.model, error) });
}
