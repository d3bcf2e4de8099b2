import { workerFrom } from '../worker/workerFrom.js';
import scanWorker from './scan.worker.js?bundled';

/** Creates the worker that is inlined in the library. It has a file of its own, which is loaded with the first picture. */
export const createInlineScanWorker = (): Worker => workerFrom(scanWorker);
