/** The worker's first statement. Once it runs, the text has been read and can be freed. */
const FREE_TEXT = 'URL.revokeObjectURL(import.meta.url);';

/** Creates a worker from the text of its module. */
export function workerFrom(text: string): Worker {
  const url = URL.createObjectURL(new Blob([FREE_TEXT, text], { type: 'text/javascript' }));
  const worker = new Worker(url, { type: 'module' });
  // A Content-Security-Policy that forbids the worker is reported only by this event.
  worker.addEventListener('error', () => URL.revokeObjectURL(url));
  return worker;
}
