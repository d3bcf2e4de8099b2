import { serveTasks } from '../serveTasks.js';
import { contourTasks } from './contourTasks.js';

serveTasks(contourTasks);
