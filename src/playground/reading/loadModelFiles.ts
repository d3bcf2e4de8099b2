import type { FileChangeKind } from '../../viewer/files/common/fileChanges.js';
import { ModelError } from '../../viewer/files/common/ModelError.js';
import { readingTime } from '../../viewer/files/common/ModelFile.js';
import type { UpAxis } from '../../viewer/files/mesh/UpAxis.js';
import type { ModelFile, ReadModel } from '../../viewer/files/readModel.js';
import type { FineRequest, ModelWorkerMessage } from './model.worker.js';
import { PAGE_SURROUNDINGS } from './pageSurroundings.js';

/** A file that the built page has begun to read before its first script: see tools/building/fetchedAhead.ts. */
export interface ReadAhead {
  /** The absolute URL of the file. */
  url: string;
  /** Rejects if the file could not be fetched. */
  files: Promise<readonly ModelFile[]>;
  worker: Worker;
  /** The worker's messages so far. */
  messages: ModelWorkerMessage[];
  /** Whether the worker has stopped, or did not start. */
  hasFailed: boolean;
}

declare global {
  var hatchingReadAhead: ReadAhead | undefined;
}

/** Returns, once, the reading in progress for a URL; undefined if there is none, or it has failed. */
export function takeReadAhead(url: string): ReadAhead | undefined {
  const ahead = globalThis.hatchingReadAhead;
  globalThis.hatchingReadAhead = undefined;
  if (!ahead) return undefined;
  if (!ahead.hasFailed && ahead.url === new URL(url, document.baseURI).href) return ahead;
  ahead.worker.terminate();
  return undefined;
}

export interface LoadOptions {
  /** Aborting terminates the worker at once and rejects with the signal's reason. */
  signal: AbortSignal;
  /** Called with a description of the current step and, if known, how far it is in [0, 1]. */
  onStage: (stage: string, progress?: number) => void;
  /** Called with a coarse copy of a large model before that is ready. */
  onCoarse?: ((model: ReadModel) => void) | undefined;
  /** The maximum number of triangles after simplification; by default as many as a sheet shows. */
  most?: number | undefined;
  /** Index of the material variant. */
  variant?: number | undefined;
  /** Kinds of changes that are switched from what is usual. */
  switched?: readonly FileChangeKind[] | undefined;
  /** The up axis for which views are wanted, or `file` for that of the file; none are by default. */
  viewsFor?: UpAxis | 'file' | undefined;
}

/** Only smaller files are read on the main thread, which is blocked meanwhile and cannot be cancelled. */
const MAX_BYTES_WITHOUT_WORKER = 4 * 2 ** 20;

/** The worker did not start: its script is missing, or a Content-Security-Policy forbids workers. */
class NotStarted extends Error {}

/**
 * Reads a model in a worker of its own, which is terminated if the caller aborts or it is silent for too long: some files keep a parser
 * busy for minutes. Where no worker starts, small files are read on the main thread.
 *
 * @param files the files, or a promise of them: the worker starts meanwhile
 * @param ahead a worker that was given the same files already
 * @throws ModelError with one sentence for the user, or the promise's reason
 */
export async function loadModelFiles(
  files: readonly ModelFile[] | Promise<readonly ModelFile[]>,
  options: LoadOptions,
  ahead?: ReadAhead,
): Promise<ReadModel> {
  options.signal.throwIfAborted();
  try {
    return await readInWorker(files, options, ahead);
  } catch (error) {
    if (error instanceof NotStarted) return readHere(await files, options);
    throw error;
  }
}

async function readHere(
  files: readonly ModelFile[],
  { signal, onStage, variant, switched, viewsFor }: LoadOptions,
): Promise<ReadModel> {
  const bytes = sizeOf(files);
  if (bytes > MAX_BYTES_WITHOUT_WORKER) {
    const [has, takes] = [bytes, MAX_BYTES_WITHOUT_WORKER].map((size) => Math.ceil(size / 2 ** 20));
    throw new ModelError(
      `The file has ${has} MB. It takes a reader in the background, which did not start on this page; without one, up to ${takes} MB can be read.`,
    );
  }
  const { readModel } = await import('../../viewer/files/readModel.js');
  const { withPictures } = await import('../../viewer/files/pictures/decodePictures.js');
  signal.throwIfAborted();
  const read = await readModel(files, onStage, PAGE_SURROUNDINGS, { variant, switched });
  const model = await withPictures(read, onStage, PAGE_SURROUNDINGS);
  signal.throwIfAborted();
  if (!viewsFor) return model;
  const { withViews } = await import('../../viewer/views/withViews.js');
  return withViews(model, viewsFor === 'file' ? read.upAxis : viewsFor, onStage);
}

/** @throws NotStarted if there are no workers */
export function startWorker(): Worker {
  try {
    return new Worker(new URL('./model.worker.ts', import.meta.url), { type: 'module', name: 'model' });
  } catch {
    // The browser has no workers, or the page may not start one.
    throw new NotStarted();
  }
}

const sizeOf = (files: readonly ModelFile[]): number => files.reduce((sum, { content }) => sum + content.size, 0);

async function readInWorker(
  given: readonly ModelFile[] | Promise<readonly ModelFile[]>,
  { signal, onStage, onCoarse, most, variant, switched, viewsFor }: LoadOptions,
  ahead: ReadAhead | undefined,
): Promise<ReadModel> {
  const worker = ahead?.worker ?? startWorker();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isOver = false;
  try {
    return await new Promise<ReadModel>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      let bytes = 0;
      const restartTimer = (): void => {
        clearTimeout(timer);
        const seconds = Math.ceil(readingTime(bytes));
        const sentence = `The file was put aside, because its reader made no progress for ${seconds} seconds.`;
        timer = setTimeout(() => reject(new ModelError(sentence)), seconds * 1000);
      };
      let hasSpoken = false;
      const fail = (event: Event): void => {
        event.preventDefault();
        // The error of a worker that failed to load has no message. Other messages are the engine's, and not for users.
        const isLoaded = hasSpoken || ('message' in event && Boolean(event.message));
        reject(isLoaded ? new ModelError('The file could not be read: the reader stopped.') : new NotStarted());
      };
      worker.addEventListener('error', fail);
      worker.addEventListener('messageerror', fail);
      const hear = (data: ModelWorkerMessage): void => {
        hasSpoken = true;
        if (data.kind === 'stage') {
          bytes = Math.max(bytes, data.bytes ?? 0);
          restartTimer();
          onStage(data.stage);
        } else if (data.kind === 'coarse') {
          restartTimer();
          onCoarse?.(data.model);
        } else if (data.kind === 'done') resolve(data.model);
        else if (data.kind === 'failed') reject(new ModelError(data.sentence));
      };
      ahead?.messages.forEach(hear);
      worker.addEventListener('message', ({ data }: MessageEvent<ModelWorkerMessage>) => hear(data));
      const post = (files: readonly ModelFile[]): void => {
        if (isOver) return;
        bytes = sizeOf(files);
        restartTimer();
        const isPlain = [most, variant, switched, viewsFor].every((one) => one === undefined);
        const request: FineRequest = { files, most, variant, switched, viewsFor };
        if (!ahead) worker.postMessage(isPlain ? files : request);
      };
      if (given instanceof Promise) given.then(post).catch(reject);
      else post(given);
    });
  } finally {
    isOver = true;
    clearTimeout(timer);
    worker.terminate();
  }
}
