import { serveTasks } from '../worker/serveTasks.js';
import { scanTasks } from './scanTasks.js';

serveTasks(scanTasks);
