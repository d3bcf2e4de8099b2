import { ModelError } from './ModelError.js';
import type { ModelWorkerMessage } from './model.worker.js';
import type { ModelFile, ReadModel } from './readModel.js';

export interface LoadOptions {
  /** Aborting terminates the worker at once and rejects with the signal's reason. */
  signal: AbortSignal;
  /** Called with a few words on what is being done. */
  onStage: (stage: string) => void;
  /** Seconds after which reading is aborted. */
  deadlineSeconds?: number;
}

/**
 * Reads a model in a worker of its own, which is terminated if the caller aborts or the deadline passes: some files
 * keep a parser busy for minutes. Without workers it reads on the main thread.
 *
 * @throws ModelError with one sentence for the user
 */
export async function loadModelFiles(files: readonly ModelFile[], options: LoadOptions): Promise<ReadModel> {
  const { signal, onStage, deadlineSeconds = 60 } = options;
  signal.throwIfAborted();
  if (typeof Worker === 'undefined') {
    const { readModel } = await import('./readModel.js');
    return readModel(files, onStage);
  }
  const worker = new Worker(new URL('./model.worker.ts', import.meta.url), { type: 'module', name: 'model' });
  let timer: ReturnType<typeof setTimeout> | undefined;
  try {
    return await new Promise<ReadModel>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      timer = setTimeout(
        () =>
          reject(new ModelError(`The file was still not read after ${deadlineSeconds} seconds, so it was put aside.`)),
        deadlineSeconds * 1000,
      );
      worker.addEventListener('error', (event) => {
        event.preventDefault();
        // A reader that did not load has no message. What others say is JavaScript's.
        reject(
          new ModelError(`The file could not be read: the reader ${event.message ? 'stopped' : 'did not start'}.`),
        );
      });
      worker.addEventListener('message', ({ data }: MessageEvent<ModelWorkerMessage>) => {
        if (data.kind === 'stage') onStage(data.stage);
        else if (data.kind === 'done') resolve(data.model);
        else reject(new ModelError(data.message));
      });
      worker.postMessage(files);
    });
  } finally {
    clearTimeout(timer);
    worker.terminate();
  }
}
