import handWorker from './hand.worker.js?bundled';
import { workerFrom } from './workerFrom.js';

/** Creates the inlined worker. This file is loaded with the first hand or picture. */
export const createInlineHandWorker = (): Worker => workerFrom(handWorker);
