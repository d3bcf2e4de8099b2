import { workerFrom } from '../../worker/workerFrom.js';
import svgWorker from './svg.worker.js?bundled';

/** Creates the worker that is inlined in the library. It has a file of its own, which is loaded with the first drawing. */
export const createInlineSvgWorker = (): Worker => workerFrom(svgWorker);
