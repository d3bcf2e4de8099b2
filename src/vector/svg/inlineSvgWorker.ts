import { workerFrom } from '../../worker/workerFrom.js';
import svgWorker from './svg.worker.js?bundled';

/** Creates the inlined worker. It is a file of its own, imported with the first drawing. */
export const createInlineSvgWorker = (): Worker => workerFrom(svgWorker);
