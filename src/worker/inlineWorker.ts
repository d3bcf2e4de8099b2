import BakeWorker from './bake.worker.js?worker&inline';

/** A worker from the code that the library carries within itself. A file of its own, loaded with the first task. */
export const createInlineWorker = (): Worker => new BakeWorker();
