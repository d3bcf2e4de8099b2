/** What every long computation accepts, whether it runs in the worker or in slices on the main thread. */
export interface TaskOptions {
  /** Aborting rejects the promise with the signal's reason and frees what the task held. */
  signal?: AbortSignal | undefined;
  /** Called with rising values in [0, 1]. */
  onProgress?: ((progress: number) => void) | undefined;
  /**
   * Makes the worker. The default one is inlined; where the Content-Security-Policy forbids that (`worker-src` without
   * `blob:`), pass one from your own address, with Vite for example
   *
   *     import BakeWorker from 'three-hatching/bake.worker?worker';
   *     const createWorker = () => new BakeWorker();
   *
   * Requests with the same function share one worker, so keep the function. Where no worker can be made, the main
   * thread computes in slices of a few milliseconds.
   */
  createWorker?: (() => Worker) | undefined;
}
