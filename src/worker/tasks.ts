import { geometryTasks } from './kinds/geometryTasks.js';
import { mapTasks } from './kinds/mapTasks.js';
import { sceneTasks } from './kinds/sceneTasks.js';

/** All tasks of the worker, by name. */
export const tasks = { ...geometryTasks, ...mapTasks, ...sceneTasks };

export type BakingTasks = typeof tasks;
