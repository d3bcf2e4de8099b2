import { serveTasks } from '../../worker/serveTasks.js';
import { lineTasks } from '../drawLines.js';

serveTasks(lineTasks);
