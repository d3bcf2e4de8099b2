import { serveTasks } from '../serveTasks.js';
import { sceneTasks } from './sceneTasks.js';

serveTasks(sceneTasks);
