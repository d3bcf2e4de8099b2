import { serveTasks } from '../serveTasks.js';
import { geometryTasks } from './geometryTasks.js';

serveTasks(geometryTasks);
