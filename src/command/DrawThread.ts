import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import { readingTime } from '../viewer/files/readingTime.js';
import type { DrawingOptions } from './DrawingOptions.js';

/** A model to be drawn in a thread. */
export interface DrawTask {
  /** The path of its file, or its name where the content is given. */
  model: string;
  /** What is in it; left out, it is read from the file. */
  content?: Uint8Array;
  options: DrawingOptions;
}

/** What was counted of a drawing. Lengths are in millimetres. */
export interface DrawingCounts {
  paths: number;
  drawn: number;
  travelBefore: number;
  travelAfter: number;
}

/** What a thread says: how far it is, a sentence for the user, a drawing, or how it ended. */
export type DrawMessage =
  | { kind: 'progress'; stage: string; progress: number; bytes?: number | undefined }
  | { kind: 'note'; sentence: string }
  | { kind: 'drawing'; frame: number; svg: string; counts: DrawingCounts }
  | { kind: 'done'; isWhole: boolean }
  | { kind: 'failed'; sentence: string };

/** Readers that say nothing for so many times as long as they may take on a page are put aside. */
const PATIENCE = 4;

/** The script of the threads, which lies beside the command. */
const SCRIPT = join(dirname(fileURLToPath(import.meta.url)), 'draw.worker.js');

/**
 * Draws a model in a thread of its own: some files keep a parser busy for minutes, or need all the memory there is. So it can be stopped at
 * any time, and what happens to one model is nothing to the others.
 *
 * @param bytes of the model's file
 * @param onMessage is given what the thread says, and what it asks for is done before it ends
 * @returns whether nothing is missing that belongs to the drawing
 * @throws Error whose message is a sentence about the model, or the reason of the signal
 */
export async function drawInThread(
  task: DrawTask,
  bytes: number,
  signal: AbortSignal,
  onMessage: (message: DrawMessage) => void,
): Promise<boolean> {
  signal.throwIfAborted();
  // What loaders write into the console is nothing to users.
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
