/** The worker's first statement: it has been read, so its text need not be kept any longer. */
const FREE_TEXT = 'URL.revokeObjectURL(import.meta.url);';

/** Creates a worker from the text of its module. */
export function workerFrom(text: string): Worker {
  const url = URL.createObjectURL(new Blob([FREE_TEXT, text], { type: 'text/javascript' }));
  const worker = new Worker(url, { type: 'module' });
  // A Content-Security-Policy that forbids it is reported by this event alone.
  worker.addEventListener('error', () => URL.revokeObjectURL(url));
  return worker;
}
