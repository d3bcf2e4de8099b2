import { serveTasks } from './serveTasks.js';
import { tasks } from './tasks.js';

serveTasks(tasks);
