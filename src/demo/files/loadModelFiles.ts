import { ModelError } from './ModelError.js';
import type { ModelWorkerMessage } from './model.worker.js';
import { readingTime } from './readingTime.js';
import type { ModelFile, ReadModel } from './readModel.js';

export interface LoadOptions {
  /** Aborting terminates the worker at once and rejects with the signal's reason. */
  signal: AbortSignal;
  /** Called with a few words on what is being done. */
  onStage: (stage: string) => void;
}

/**
 * Reads a model in a worker of its own, which is terminated if the caller aborts or it is silent for too long: some files
 * keep a parser busy for minutes. Without workers it reads on the main thread.
 *
 * @throws ModelError with one sentence for the user
 */
export async function loadModelFiles(files: readonly ModelFile[], options: LoadOptions): Promise<ReadModel> {
  const { signal, onStage } = options;
  signal.throwIfAborted();
  if (typeof Worker === 'undefined') {
    const { readModel } = await import('./readModel.js');
    const { withPictures } = await import('./decodePictures.js');
    return withPictures(await readModel(files, onStage), onStage);
  }
  const worker = new Worker(new URL('./model.worker.ts', import.meta.url), { type: 'module', name: 'model' });
  let timer: ReturnType<typeof setTimeout> | undefined;
  try {
    return await new Promise<ReadModel>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      let bytes = files.reduce((sum, { content }) => sum + content.size, 0);
      const restartTimer = (): void => {
        clearTimeout(timer);
        const seconds = Math.ceil(readingTime(bytes));
        const sentence = `The file was put aside, because its reader made no progress for ${seconds} seconds.`;
        timer = setTimeout(() => reject(new ModelError(sentence)), seconds * 1000);
      };
      restartTimer();
      const fail = (event: Event): void => {
        event.preventDefault();
        // A reader that did not load has no message. What others say is JavaScript's.
        const what = 'message' in event && event.message ? 'stopped' : 'did not start';
        reject(new ModelError(`The file could not be read: the reader ${what}.`));
      };
      worker.addEventListener('error', fail);
      worker.addEventListener('messageerror', fail);
      worker.addEventListener('message', ({ data }: MessageEvent<ModelWorkerMessage>) => {
        if (data.kind === 'stage') {
          bytes = Math.max(bytes, data.bytes ?? 0);
          restartTimer();
          onStage(data.stage);
        } else if (data.kind === 'done') resolve(data.model);
        else reject(new ModelError(data.sentence));
      });
      worker.postMessage(files);
    });
  } finally {
    clearTimeout(timer);
    worker.terminate();
  }
}
