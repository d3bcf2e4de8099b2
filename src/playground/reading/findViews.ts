import { Slices } from '../../viewer/files/common/Slices.js';
import type { UpAxis } from '../../viewer/files/mesh/findUpAxis.js';
import type { ChosenView } from '../../viewer/views/chooseViews.js';
import type { ViewTriangles } from '../../viewer/views/viewSurface.js';
import { startWorker } from './loadModelFiles.js';
import type { ModelWorkerMessage, ViewRequest } from './model.worker.js';

/**
 * Finds the views that show the triangles of a scene best, in a worker; where none starts, on the main thread.
 *
 * @throws the signal's reason
 */
export async function findViews(
  triangles: ViewTriangles,
  up: UpAxis,
  signal: AbortSignal,
): Promise<readonly ChosenView[]> {
  signal.throwIfAborted();
  let worker: Worker;
  try {
    worker = startWorker();
  } catch {
    return viewsHere(triangles, up, signal);
  }
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.addEventListener('message', ({ data }: MessageEvent<ModelWorkerMessage>) => {
        if (data.kind === 'views') resolve(data.views);
        else if (data.kind === 'failed') reject(new Error(data.sentence));
      });
      worker.addEventListener('error', (event) => {
        event.preventDefault();
        resolve(viewsHere(triangles, up, signal));
      });
      worker.postMessage({ triangles, up } satisfies ViewRequest);
    });
  } finally {
    worker.terminate();
  }
}

async function viewsHere(triangles: ViewTriangles, up: UpAxis, signal: AbortSignal): Promise<readonly ChosenView[]> {
  const { chooseViews } = await import('../../viewer/views/chooseViews.js');
  const slices = new Slices(signal);
  const task = chooseViews(triangles, up);
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
    await slices.next();
  }
}
