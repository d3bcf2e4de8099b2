/** What every long computation accepts, whether it runs in the worker or in slices on the main thread. */
export interface TaskOptions {
  /** Aborting rejects the promise with the signal's reason and frees what the task held. */
  signal?: AbortSignal | undefined;
  /** Called with rising values in [0, 1]. */
  onProgress?: ((progress: number) => void) | undefined;
  /**
   * Makes the worker. The default is an inlined one; under a Content-Security-Policy without `worker-src blob:` pass
   * `() => new Worker(new URL('three-hatching/bake.worker', import.meta.url), { type: 'module' })` or your bundler's way.
   */
  createWorker?: (() => Worker) | undefined;
}
