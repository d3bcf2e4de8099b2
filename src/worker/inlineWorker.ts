import bakeWorker from './bake.worker.js?bundled';

/** The worker's first statement: it has been read, so its text need not be kept any longer. */
const FREE_TEXT = 'URL.revokeObjectURL(import.meta.url);';

/** Creates the worker that is inlined in the library. It has a file of its own, which is loaded with the first task. */
export function createInlineWorker(): Worker {
  const url = URL.createObjectURL(new Blob([FREE_TEXT, bakeWorker], { type: 'text/javascript' }));
  const worker = new Worker(url, { type: 'module' });
  // A Content-Security-Policy that forbids it is reported by this event alone.
  worker.addEventListener('error', () => URL.revokeObjectURL(url));
  return worker;
}
