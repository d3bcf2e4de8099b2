import { workerFrom } from '../workerFrom.js';
import mapWorker from './map.worker.js?bundled';

/** Creates the inlined worker for the tasks of `mapTasks`. This file is loaded with the first of them. */
export const createInlineMapWorker = (): Worker => workerFrom(mapWorker);
