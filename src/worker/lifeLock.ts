/**
 * The browser gives back the locks of a worker as soon as it has ended, whatever has ended it. So whoever waits for a lock that a
 * worker holds all its life knows at once when it is gone, where no event tells. Only in secure contexts (https, localhost).
 */

/** Takes a lock until this worker ends. Returns its name; undefined where there are no locks. */
export function holdLifeLock(): Promise<string | undefined> {
  const { locks } = navigator;
  if (!locks) return Promise.resolve(undefined);
  const name = `three-hatching ${crypto.randomUUID()}`;
  return new Promise((resolve) => {
    const hold = (): Promise<never> => {
      resolve(name);
      return new Promise(() => {});
    };
    // Refused where the worker has no origin, as from a data: address.
    locks.request(name, hold).catch(() => resolve(undefined));
  });
}

/** Calls `onEnd` when the worker that holds a lock has ended. Returns what stops waiting. */
export function awaitEnd(lock: string, onEnd: () => void): () => void {
  const waiting = new AbortController();
  navigator.locks.request(lock, { signal: waiting.signal }, onEnd).catch(() => {});
  return () => waiting.abort();
}
