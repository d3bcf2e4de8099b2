import { serveTasks } from './serveTasks.js';
import { handTasks } from './handTasks.js';

serveTasks(handTasks);
