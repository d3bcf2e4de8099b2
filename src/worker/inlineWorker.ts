import BakeWorker from './bake.worker.js?worker&inline';

/** Creates the worker that is inlined in the library. It has a file of its own, which is loaded with the first task. */
export const createInlineWorker = (): Worker => new BakeWorker();
