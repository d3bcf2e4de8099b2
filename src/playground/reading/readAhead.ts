import type { ModelFile } from '../../viewer/files/readModel.js';
import type { ModelWorkerMessage } from './model.worker.js';

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
