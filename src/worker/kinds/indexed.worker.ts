import { serveTasks } from '../serveTasks.js';
import { indexedTasks } from './indexedTasks.js';

serveTasks(indexedTasks);
