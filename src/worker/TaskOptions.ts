/** Options of every long task, whether it runs in a worker or in slices on the main thread. */
export interface TaskOptions {
  /** Aborting rejects the promise with the signal's reason and frees the task's memory. */
  signal?: AbortSignal | undefined;
  /** Called with rising values in [0, 1]. */
  onProgress?: ((progress: number) => void) | undefined;
  /**
   * Creates a worker. By default the library inlines its worker. If your Content-Security-Policy forbids that (`worker-src`
   * without `blob:`), create one from your own origin. With Vite for example:
   *
   *     import BakeWorker from 'three-hatching/bake.worker?worker';
   *     const createWorker = () => new BakeWorker();
   *
   * A function that returns anything but a Worker causes a TypeError. Requests with the same function share their workers (one
   * per core while there is work for them, four at most), so always pass the same function. If no worker can be started, tasks
   * run on the main thread in slices of a few milliseconds.
   */
  createWorker?: (() => Worker) | undefined;
}
