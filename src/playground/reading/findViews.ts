import { Slices } from '../../viewer/files/common/Slices.js';
import { startWorker } from './loadModelFiles.js';
import type { FoundViews, ModelWorkerMessage, ViewRequest } from './model.worker.js';

/**
 * Finds the views that show the triangles of a scene best, and what cameras see of them, in a worker; where none starts, on the main
 * thread.
 *
 * @param request the triangles, the axis that points up, and cameras in the space of the triangles
 * @throws the signal's reason
 */
export async function findViews(request: ViewRequest, signal: AbortSignal): Promise<FoundViews> {
  signal.throwIfAborted();
  let worker: Worker;
  try {
    worker = startWorker();
  } catch {
    return viewsHere(request, signal);
  }
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.addEventListener('message', ({ data }: MessageEvent<ModelWorkerMessage>) => {
        if (data.kind === 'views') resolve(data);
        else if (data.kind === 'failed') reject(new Error(data.sentence));
      });
      worker.addEventListener('error', (event) => {
        event.preventDefault();
        resolve(viewsHere(request, signal));
      });
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}

async function viewsHere({ triangles, up, cameras }: ViewRequest, signal: AbortSignal): Promise<FoundViews> {
  const [{ chooseViews }, { cameraSights }] = await Promise.all([
    import('../../viewer/views/chooseViews.js'),
    import('../../viewer/views/cameraSights.js'),
  ]);
  const slices = new Slices(signal);
  const task = chooseViews(triangles, up);
  for (;;) {
    const step = task.next();
    if (step.done) return { views: step.value, sights: cameraSights(triangles, cameras) };
    await slices.next();
  }
}
