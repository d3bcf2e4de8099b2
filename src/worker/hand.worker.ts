import { handTasks } from './handTasks.js';
import { serveTasks } from './serveTasks.js';

serveTasks(handTasks);
