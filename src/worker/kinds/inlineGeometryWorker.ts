import { workerFrom } from '../workerFrom.js';
import geometryWorker from './geometry.worker.js?bundled';

/** Creates the inlined worker for the tasks of `geometryTasks`. This file is loaded with the first of them. */
export const createInlineGeometryWorker = (): Worker => workerFrom(geometryWorker);
