import { bakingTasks } from './bakingTasks.js';
import { disposedError } from './disposedError.js';
import type { MakeAgain } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import type { NameIn, RequestOf, ResultOf, TaskSet, Tasks } from './TaskSet.js';
import type { BakingTasks } from './tasks.js';
import type { WorkerPool } from './WorkerPool.js';

type CreateWorker = () => Worker | null;

const createNoWorker: CreateWorker = () => null;

/** For each set of tasks the pool of each `createWorker` function, as long as it has a worker. */
const poolsOf = /* @__PURE__ */ new Map<object, Map<CreateWorker, WorkerPool<Tasks>>>();

/** How often everything was disposed of. */
let disposals = 0;

/**
 * Runs a task in a worker: in one that `options.createWorker` creates, or else in the inlined one. Without workers it runs in
 * slices on the main thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 *
 * @param makeAgain makes the same request again, so that the task can start over if its worker dies
 */
export const runTask = <Name extends NameIn<BakingTasks>>(
  name: Name,
  request: RequestOf<BakingTasks, Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<RequestOf<BakingTasks, Name>>,
): Promise<ResultOf<BakingTasks, Name>> => runTaskOf(bakingTasks, name, request, options, makeAgain);

/** The same for the tasks of any set. */
export async function runTaskOf<All extends Tasks, Name extends NameIn<All>>(
  set: TaskSet<All>,
  name: Name,
  request: RequestOf<All, Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<RequestOf<All, Name>>,
): Promise<ResultOf<All, Name>> {
  const disposalsBefore = disposals;
  // What runs tasks is fetched with the first of them, and so is the worker.
  const [{ WorkerPool }, createWorker] = await Promise.all([
    import('./WorkerPool.js'),
    options.createWorker ?? fetchInlineWorker(set),
  ]);
  if (disposals !== disposalsBefore) throw disposedError();
  const pools = poolsOf.get(set) ?? new Map<CreateWorker, WorkerPool<Tasks>>();
  poolsOf.set(set, pools);
  let pool = pools.get(createWorker) as WorkerPool<All> | undefined;
  if (!pool) {
    pool = new WorkerPool(set, createWorker, () => pools.delete(createWorker));
    pools.set(createWorker, pool as unknown as WorkerPool<Tasks>);
  }
  return pool.run(name, request, options, makeAgain);
}

async function fetchInlineWorker<All extends Tasks>(set: TaskSet<All>): Promise<CreateWorker> {
  return typeof Worker === 'undefined' ? createNoWorker : set.fetchWorker();
}

/**
 * Terminates every worker that three-hatching has started and rejects all pending requests. You will rarely need it: idle
 * workers end after a few seconds. The next request starts a new worker.
 */
export function disposeHatchingWorkers(): void {
  disposals++;
  for (const pools of poolsOf.values()) for (const pool of pools.values()) pool.dispose();
  poolsOf.clear();
}
