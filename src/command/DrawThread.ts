import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import { readingTime } from '../viewer/files/readingTime.js';
import type { DrawingOptions } from './DrawingOptions.js';

/** A model to draw in a worker thread. */
export interface DrawTask {
  /** The path of the model's file, or its name where `content` is given. */
  model: string;
  /** The bytes of the file; read from `model` if left out. */
  content?: Uint8Array;
  options: DrawingOptions;
}

/** Counts of one drawing. Lengths are in millimetres. */
export interface DrawingCounts {
  paths: number;
  drawn: number;
  travelBefore: number;
  travelAfter: number;
}

/** A message from the thread: progress, a note for the user, a drawing, or the result. */
export type DrawMessage =
  | { kind: 'progress'; stage: string; progress: number; bytes?: number | undefined }
  | { kind: 'note'; sentence: string }
  | { kind: 'drawing'; frame: number; svg: string; counts: DrawingCounts }
  | { kind: 'done'; isWhole: boolean }
  | { kind: 'failed'; sentence: string };

/** A reader without progress is stopped after this multiple of its time limit on the page. */
const PATIENCE = 4;

/** The script of the threads, in the command's own folder. */
const SCRIPT = join(dirname(fileURLToPath(import.meta.url)), 'draw.worker.js');

/**
 * Draws a model in a worker thread, because some files keep a parser busy for minutes or use up the memory. A thread can be stopped at any
 * time, and its failure does not affect other models.
 *
 * @param bytes of the model's file
 * @param onMessage receives the thread's messages; what it returns is awaited before this function ends
 * @returns whether the drawing is complete
 * @throws Error whose message is a sentence about the model, or the reason of the signal
 */
export async function drawInThread(
  task: DrawTask,
  bytes: number,
  signal: AbortSignal,
  onMessage: (message: DrawMessage) => void,
): Promise<boolean> {
  signal.throwIfAborted();
  // Keeps the loaders' console output from the user.
  const worker = new Worker(SCRIPT, { workerData: task, stdout: true, stderr: true });
  let timer: NodeJS.Timeout | undefined;
  let onAbort = (): void => {};
  try {
    return await new Promise<boolean>((resolve, reject) => {
      onAbort = () => reject(signal.reason);
      signal.addEventListener('abort', onAbort, { once: true });
      let size = bytes;
      const wait = (): void => {
        clearTimeout(timer);
        const seconds = PATIENCE * Math.ceil(readingTime(size));
        const sentence = `${task.model} was put aside, because there was no progress for ${seconds} seconds.`;
        timer = setTimeout(() => reject(new Error(sentence)), 1000 * seconds);
      };
      wait();
      worker.on('error', (error) => reject(new Error(whyEnded(task.model, error))));
      worker.on('exit', () => reject(new Error(`${task.model} could not be drawn: its thread has ended.`)));
      worker.on('message', (message: DrawMessage) => {
        if (message.kind === 'progress') size = Math.max(size, message.bytes ?? 0);
        wait();
        if (message.kind === 'done') resolve(message.isWhole);
        else if (message.kind === 'failed') reject(new Error(message.sentence));
        else onMessage(message);
      });
    });
  } finally {
    clearTimeout(timer);
    signal.removeEventListener('abort', onAbort);
    await worker.terminate();
  }
}

function whyEnded(model: string, error: NodeJS.ErrnoException): string {
  if (error.code === 'ERR_WORKER_OUT_OF_MEMORY')
    return `${model} needs more memory than there is; give Node more with NODE_OPTIONS=--max-old-space-size=8192, say.`;
  return `${model} could not be drawn (${error.message}).`;
}
