import { disposedError } from './disposedError.js';
import type { MakeAgain } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';
import type { WorkerPool } from './WorkerPool.js';

type CreateWorker = () => Worker | null;

const createNoWorker: CreateWorker = () => null;

/** The pool of each `createWorker` function, as long as it has a worker. */
const pools = /* @__PURE__ */ new Map<CreateWorker, WorkerPool>();

/** How often everything was disposed of. */
let disposals = 0;

/**
 * Runs a task in a worker: in one that `options.createWorker` creates, or else in the inlined one. Without workers it runs in
 * slices on the main thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 *
 * @param makeAgain makes the same request again, so that the task can start over if its worker dies
 */
export async function runTask<Name extends TaskName>(
  name: Name,
  request: TaskRequest<Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<TaskRequest<Name>>,
): Promise<TaskResult<Name>> {
  const disposalsBefore = disposals;
  // What runs tasks is fetched with the first of them, and so is the worker.
  const [{ WorkerPool }, createWorker] = await Promise.all([
    import('./WorkerPool.js'),
    options.createWorker ?? fetchInlineWorker(),
  ]);
  if (disposals !== disposalsBefore) throw disposedError();
  let pool = pools.get(createWorker);
  if (!pool) {
    pool = new WorkerPool(createWorker, () => pools.delete(createWorker));
    pools.set(createWorker, pool);
  }
  return pool.run(name, request, options, makeAgain);
}

async function fetchInlineWorker(): Promise<CreateWorker> {
  return typeof Worker === 'undefined' ? createNoWorker : (await import('./inlineWorker.js')).createInlineWorker;
}

/**
 * Terminates every worker that three-hatching has started and rejects all pending requests. You will rarely need it: idle
 * workers end after a few seconds. The next request starts a new worker.
 */
export function disposeHatchingWorkers(): void {
  disposals++;
  for (const pool of pools.values()) pool.dispose();
  pools.clear();
}
