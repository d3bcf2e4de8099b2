import { parentPort, workerData } from 'node:worker_threads';
import type { DrawMessage, DrawTask } from '../draw.js';

/** The script of the drawing thread. Its modules are imported at run time, so that it can report one that is not installed. */
const say = (message: DrawMessage): void => parentPort?.postMessage(message);

const isInstalled = await import('three').then(
  () => true,
  () => false,
);
if (isInstalled) await draw(workerData as DrawTask);
else {
  const sentence = 'To draw models, three must be installed beside three-hatching: npm install three.';
  say({ kind: 'failed', sentence });
}

async function draw(task: DrawTask): Promise<void> {
  const [{ drawModel }, { failure }] = await Promise.all([import('./drawModel.js'), import('./failure.js')]);
  try {
    say({ kind: 'done', isWhole: await drawModel(task, say) });
  } catch (error) {
    say({ kind: 'failed', sentence: failure(task.model, error) });
  }
}
