import type { ModelFile } from '../../viewer/files/readModel.js';
import type { ModelWorkerMessage } from './model.worker.js';

/** A file that is read already: the built page has begun it before its first script, as tools/building/fetchedAhead.ts says. */
export interface ReadAhead {
  /** The whole address of the file. */
  url: string;
  /** Rejects if the file could not be fetched. */
  files: Promise<readonly ModelFile[]>;
  worker: Worker;
  /** What the worker has said so far. */
  messages: ModelWorkerMessage[];
  /** Whether the worker has stopped, or did not start. */
  hasFailed: boolean;
}

declare global {
  var hatchingReadAhead: ReadAhead | undefined;
}

/** Takes what was begun for the file at an address, once; undefined if nothing was, or if it has failed. */
export function takeReadAhead(url: string): ReadAhead | undefined {
  const ahead = globalThis.hatchingReadAhead;
  globalThis.hatchingReadAhead = undefined;
  if (!ahead) return undefined;
  if (!ahead.hasFailed && ahead.url === new URL(url, document.baseURI).href) return ahead;
  ahead.worker.terminate();
  return undefined;
}
