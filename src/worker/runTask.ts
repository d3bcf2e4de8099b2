import type { MakeAgain } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';
import { WorkerPool } from './WorkerPool.js';

type CreateWorker = () => Worker | null;

const createNoWorker: CreateWorker = () => null;

let inlineWorker: Promise<CreateWorker> | undefined;

/** Loads what makes the library's own worker, once; again if that failed, as without a network. */
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

/** One pool per `createWorker` function, for as long as it has a worker. */
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
 * Runs a task in a worker of the page, or in one of `options.createWorker`; without workers, in slices on the main
 * thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 *
 * @param makeAgain makes the same request once more, with which the task starts again if its worker dies
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
 * Ends every worker that three-hatching has started and rejects all pending requests. Rarely needed: idle workers end by
 * themselves. The next request starts a new one.
 */
export function disposeHatchingWorkers(): void {
  for (const pool of pools.values()) pool.dispose();
  pools.clear();
}
