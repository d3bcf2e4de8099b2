import type { SlicedOptions } from '../mesh/runSliced.js';
import { type MakeAgain, TaskClient } from './TaskClient.js';
import { maxWorkers } from './TaskOptions.js';
import type { NameIn, RequestOf, ResultOf, TaskSet, Tasks } from './TaskSet.js';

export { disposedError } from './TaskClient.js';

/** Creates a worker, or returns null if there is none; may throw. */
export type CreateWorker = () => Worker | null;

/** The pools with a worker, by set of tasks and by `createWorker` function. */
export type PoolsOf = Map<object, Map<CreateWorker, WorkerPool<Tasks>>>;

/**
 * Runs tasks in several workers. Each request goes to the worker with the fewest pending requests; while all workers are busy,
 * another one is started, up to `maxWorkers`. If a worker could not be started, no other is tried.
 */
export class WorkerPool<All extends Tasks> {
  private readonly clients: TaskClient<All>[] = [];

  /**
   * @param set the tasks that its workers can run
   * @param createWorker creates a worker, or returns null if there is none; may throw.
   * @param onIdle called after the last idle worker was terminated.
   * @param warnings the sentences that were said already.
   */
  constructor(
    private readonly set: TaskSet<All>,
    private readonly createWorker: CreateWorker,
    private readonly onIdle: () => void = () => {},
    private readonly warnings = new Set<string>(),
  ) {}

  /** See `TaskClient.run`. */
  run<Name extends NameIn<All>>(
    task: Name,
    request: RequestOf<All, Name>,
    options: SlicedOptions = {},
    makeAgain?: MakeAgain<RequestOf<All, Name>>,
  ): Promise<ResultOf<All, Name>> {
    return this.choose().run(task, request, options, makeAgain);
  }

  /** Starts a worker, if there is none, for a request about to come. @throws TypeError when `createWorker` returns no Worker */
  start(): void {
    if (this.clients.length === 0) this.choose().start();
  }

  /** Terminates all workers and rejects all pending requests. */
  dispose(): void {
    for (const client of this.clients.splice(0)) client.dispose();
  }

  private choose(): TaskClient<All> {
    const { clients } = this;
    let least: TaskClient<All> | undefined;
    for (const client of clients) if (!least || client.pendingCount < least.pendingCount) least = client;
    const mayGrow = clients.length < maxWorkers() && clients.every(({ isUnavailable }) => !isUnavailable);
    if (least && (least.pendingCount === 0 || !mayGrow)) return least;
    const client: TaskClient<All> = new TaskClient(
      this.set,
      this.createWorker,
      () => this.remove(client),
      this.warnOnce,
    );
    clients.push(client);
    return client;
  }

  /** Warns only once, since several workers, of other pools too, may fail to start, or die, for the same reason. */
  private readonly warnOnce = (sentence: string): void => {
    if (!this.warnings.has(sentence)) console.warn(sentence);
    this.warnings.add(sentence);
  };

  private remove(client: TaskClient<All>): void {
    this.clients.splice(this.clients.indexOf(client), 1);
    if (this.clients.length === 0) this.onIdle();
  }
}

/** The pool for these tasks and this function, created if needed. @param warnings the sentences that were said already */
export function poolIn<All extends Tasks>(
  poolsOf: PoolsOf,
  set: TaskSet<All>,
  createWorker: CreateWorker,
  warnings?: Set<string>,
): WorkerPool<All> {
  const pools = poolsOf.get(set) ?? new Map<CreateWorker, WorkerPool<Tasks>>();
  poolsOf.set(set, pools);
  let pool = pools.get(createWorker) as WorkerPool<All> | undefined;
  if (!pool) {
    pool = new WorkerPool(set, createWorker, () => pools.delete(createWorker), warnings);
    pools.set(createWorker, pool as unknown as WorkerPool<Tasks>);
  }
  return pool;
}
