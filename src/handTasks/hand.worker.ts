import { serveTasks } from '../worker/serveTasks.js';
import { handTasks } from './handTasks.js';

serveTasks(handTasks);
