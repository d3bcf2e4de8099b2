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
