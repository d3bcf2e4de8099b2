import { workerFrom } from '../workerFrom.js';
import contourWorker from './contour.worker.js?bundled';

/** Creates the inlined worker for the tasks of `contourTasks`. This file is loaded with the first of them. */
export const createInlineContourWorker = (): Worker => workerFrom(contourWorker);
