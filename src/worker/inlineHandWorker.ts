import handWorker from './hand.worker.js?bundled';
import { workerFrom } from './workerFrom.js';

/** Creates the worker that is inlined in the library. It has a file of its own, which is loaded with the first hand or picture. */
export const createInlineHandWorker = (): Worker => workerFrom(handWorker);
