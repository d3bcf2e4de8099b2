import bakeWorker from './bake.worker.js?bundled';
import { workerFrom } from './workerFrom.js';

/** Creates the inlined worker. This file is loaded with the first task. */
export const createInlineWorker = (): Worker => workerFrom(bakeWorker);
