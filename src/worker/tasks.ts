import { contourTasks } from './kinds/contourTasks.js';
import { geometryTasks } from './kinds/geometryTasks.js';
import { indexedTasks } from './kinds/indexedTasks.js';
import { mapTasks } from './kinds/mapTasks.js';
import { sceneTasks } from './kinds/sceneTasks.js';

/** All tasks of the worker, by name. */
export const tasks = { ...indexedTasks, ...geometryTasks, ...contourTasks, ...mapTasks, ...sceneTasks };

export type BakingTasks = typeof tasks;
