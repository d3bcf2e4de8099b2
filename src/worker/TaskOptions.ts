/** Options of every long task, whether it runs in a worker or in slices on the main thread. */
export interface TaskOptions {
  /** Aborting rejects the promise with the signal's reason and frees the task's memory. */
  signal?: AbortSignal | undefined;
  /** Called with rising values in [0, 1]. */
  onProgress?: ((progress: number) => void) | undefined;
  /**
   * Makes the worker. The default worker is inlined. Where the Content-Security-Policy forbids that (`worker-src` without
   * `blob:`), pass one from your own origin. With Vite for example:
   *
   *     import BakeWorker from 'three-hatching/bake.worker?worker';
   *     const createWorker = () => new BakeWorker();
   *
   * Anything but a Worker is refused with a TypeError. Requests with the same function share workers: one
   * per core while there is work for them, four at most. So keep the function.
   * Where no worker can be made, tasks run on the main thread in slices of a few milliseconds.
   */
  createWorker?: (() => Worker) | undefined;
}
