import { workerFrom } from '../workerFrom.js';
import indexedWorker from './indexed.worker.js?bundled';

/** Creates the inlined worker for the tasks of `indexedTasks`. This file is loaded with the first of them. */
export const createInlineIndexedWorker = (): Worker => workerFrom(indexedWorker);
