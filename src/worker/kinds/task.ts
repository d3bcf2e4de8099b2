import type { Task } from '../TaskSet.js';

/** A task that runs a generator, after what it needs has loaded. */
export const task = <Request, Result>(
  run: Task<Request, Result>['run'],
  prepare?: Task<Request, Result>['prepare'],
): Task<Request, Result> => ({ run, prepare });
