import type { MakeAgain } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';
import { WorkerPool } from './WorkerPool.js';

type CreateWorker = () => Worker | null;

const createNoWorker: CreateWorker = () => null;

let inlineWorker: Promise<CreateWorker> | undefined;

/** Loads the code that creates the inlined worker, once. If that fails, as it does without a network, the next call tries again. */
function loadInlineWorker(): Promise<CreateWorker> {
  inlineWorker ??= import('./inlineWorker.js').then(
    ({ createInlineWorker }) => createInlineWorker,
    (error) => {
      inlineWorker = undefined;
      throw error;
    },
  );
  return inlineWorker;
}

/** The pool of each `createWorker` function, as long as it has a worker. */
const pools = /* @__PURE__ */ new Map<CreateWorker, WorkerPool>();

function poolFor(createWorker: CreateWorker): WorkerPool {
  let pool = pools.get(createWorker);
  if (!pool) {
    pool = new WorkerPool(createWorker, () => pools.delete(createWorker));
    pools.set(createWorker, pool);
  }
  return pool;
}

/**
 * Runs a task in a worker: in one that `options.createWorker` creates, or else in the inlined one. Without workers it runs in
 * slices on the main thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 *
 * @param makeAgain makes the same request again, so that the task can start over if its worker dies
 */
export function runTask<Name extends TaskName>(
  name: Name,
  request: TaskRequest<Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<TaskRequest<Name>>,
): Promise<TaskResult<Name>> {
  const run = (createWorker: CreateWorker): Promise<TaskResult<Name>> =>
    poolFor(createWorker).run(name, request, options, makeAgain);
  if (options.createWorker) return run(options.createWorker);
  return typeof Worker === 'undefined' ? run(createNoWorker) : loadInlineWorker().then(run);
}

/**
 * Terminates every worker that three-hatching has started and rejects all pending requests. You will rarely need it: idle
 * workers end after a few seconds. The next request starts a new worker.
 */
export function disposeHatchingWorkers(): void {
  for (const pool of pools.values()) pool.dispose();
  pools.clear();
}
