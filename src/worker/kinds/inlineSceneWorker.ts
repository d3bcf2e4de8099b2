import { workerFrom } from '../workerFrom.js';
import sceneWorker from './scene.worker.js?bundled';

/** Creates the inlined worker for the tasks of `sceneTasks`. This file is loaded with the first of them. */
export const createInlineSceneWorker = (): Worker => workerFrom(sceneWorker);
