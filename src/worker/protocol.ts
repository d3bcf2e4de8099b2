/** The messages from the client to the worker. `id` is the client's number for a request. */
export type ToWorker =
  | { type: 'run'; id: number; task: string; request: unknown }
  /** Stops the request. The worker sends no reply. */
  | { type: 'abort'; id: number }
  /** Asks for a sign of life. */
  | { type: 'ping' };

/** The messages from the worker to the client. */
export type FromWorker =
  /** The first message: the script has loaded, and requests may be posted. The worker holds `lock` as long as it lives. */
  | { type: 'ready'; lock?: string | undefined }
  /** The answer to `ping`, between two slices of work. */
  | { type: 'alive' }
  | { type: 'progress'; id: number; progress: number }
  | { type: 'done'; id: number; result: unknown }
  | { type: 'failed'; id: number; error: TransportedError };

/** An error as plain data. Structured clones of errors would differ between browsers. */
interface TransportedError {
  name: string;
  message: string;
}

const errorClasses: Record<string, ErrorConstructor> = { Error, RangeError, TypeError };

export function packError(error: unknown): TransportedError {
  if (error instanceof Error) return { name: error.name, message: error.message };
  return { name: 'Error', message: String(error) };
}

/** Rebuilds the error as an instance of its class if that is one of `errorClasses`, otherwise as an Error of the same name. */
export function unpackError({ name, message }: TransportedError): Error {
  const error = new (errorClasses[name] ?? Error)(message);
  error.name = name;
  return error;
}

/**
 * The browser releases the locks of a worker as soon as the worker has ended, whatever the reason. So a page that waits for a
 * lock which the worker holds all its life learns at once that the worker is gone, even if no event reports it. Locks exist only
 * in secure contexts (https, localhost).
 */

/** Holds a lock until this worker ends. Returns the name of the lock, or undefined if there are no locks. */
export function holdLifeLock(): Promise<string | undefined> {
  const { locks } = navigator;
  if (!locks) return Promise.resolve(undefined);
  const name = `three-hatching ${crypto.randomUUID()}`;
  return new Promise((resolve) => {
    const hold = (): Promise<never> => {
      resolve(name);
      return new Promise(() => {});
    };
    // The request is refused if the worker has no origin, for example if it comes from a data: URL.
    locks.request(name, hold).catch(() => resolve(undefined));
  });
}

/** Calls `onEnd` when the worker that holds `lock` has ended. Returns a function that stops waiting. */
export function awaitEnd(lock: string, onEnd: () => void): () => void {
  const waiting = new AbortController();
  navigator.locks.request(lock, { signal: waiting.signal }, onEnd).catch(() => {});
  return () => waiting.abort();
}
