import { serveTasks } from '../../worker/serveTasks.js';
import { lineTasks } from './lineTasks.js';

serveTasks(lineTasks);
