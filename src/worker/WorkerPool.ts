import type { SlicedOptions } from '../slices/runSliced.js';
import { type MakeAgain, TaskClient } from './TaskClient.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';

/** More workers than this at once hold more memory than they save time. */
const MOST_WORKERS = 4;

/** How many workers a page uses at most: one per core, up to four. */
export function mostWorkers(): number {
  const cores = typeof navigator === 'undefined' ? 1 : navigator.hardwareConcurrency || 1;
  return Math.min(cores, MOST_WORKERS);
}

/**
 * Runs tasks in several workers. Each request goes to the worker that has the fewest; another one starts while all of them are
 * busy, up to `mostWorkers`. Where one could not be started, no other is tried.
 */
export class WorkerPool {
  private readonly clients: TaskClient[] = [];
  private readonly warnings = new Set<string>();

  /**
   * @param createWorker makes a worker, or returns null if there is none; may throw.
   * @param onIdle called after the last idle worker has been ended.
   */
  constructor(
    private readonly createWorker: () => Worker | null,
    private readonly onIdle: () => void = () => {},
  ) {}

  /** See `TaskClient.run`. */
  run<Name extends TaskName>(
    task: Name,
    request: TaskRequest<Name>,
    options: SlicedOptions = {},
    makeAgain?: MakeAgain<TaskRequest<Name>>,
  ): Promise<TaskResult<Name>> {
    return this.choose().run(task, request, options, makeAgain);
  }

  /** Ends all workers and rejects all pending requests. */
  dispose(): void {
    for (const client of this.clients.splice(0)) client.dispose();
  }

  private choose(): TaskClient {
    const { clients } = this;
    let least: TaskClient | undefined;
    for (const client of clients) if (!least || client.pendingCount < least.pendingCount) least = client;
    const mayGrow = clients.length < mostWorkers() && clients.every(({ isUnavailable }) => !isUnavailable);
    if (least && (least.pendingCount === 0 || !mayGrow)) return least;
    const client = new TaskClient(this.createWorker, () => this.remove(client), this.warnOnce);
    clients.push(client);
    return client;
  }

  /** Several may have been started before the first was refused, or die one after another. */
  private readonly warnOnce = (sentence: string): void => {
    if (!this.warnings.has(sentence)) console.warn(sentence);
    this.warnings.add(sentence);
  };

  private remove(client: TaskClient): void {
    this.clients.splice(this.clients.indexOf(client), 1);
    if (this.clients.length === 0) this.onIdle();
  }
}
