import { serveTasks } from '../serveTasks.js';
import { mapTasks } from './mapTasks.js';

serveTasks(mapTasks);
