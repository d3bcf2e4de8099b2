import type { SlicedOptions } from '../slices/runSliced.js';
import { maxWorkers } from './maxWorkers.js';
import { type MakeAgain, TaskClient } from './TaskClient.js';
import type { TaskName, TaskRequest, TaskResult } from './tasks.js';

/**
 * Runs tasks in several workers. Each request goes to the worker with the fewest pending requests; while all workers are busy,
 * another one is started, up to `maxWorkers`. If a worker could not be started, no other is tried.
 */
export class WorkerPool {
  private readonly clients: TaskClient[] = [];
  private readonly warnings = new Set<string>();

  /**
   * @param createWorker creates a worker, or returns null if there is none; may throw.
   * @param onIdle called after the last idle worker was terminated.
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

  /** Terminates all workers and rejects all pending requests. */
  dispose(): void {
    for (const client of this.clients.splice(0)) client.dispose();
  }

  private choose(): TaskClient {
    const { clients } = this;
    let least: TaskClient | undefined;
    for (const client of clients) if (!least || client.pendingCount < least.pendingCount) least = client;
    const mayGrow = clients.length < maxWorkers() && clients.every(({ isUnavailable }) => !isUnavailable);
    if (least && (least.pendingCount === 0 || !mayGrow)) return least;
    const client = new TaskClient(this.createWorker, () => this.remove(client), this.warnOnce);
    clients.push(client);
    return client;
  }

  /** Warns only once, since several workers may fail to start, or die, for the same reason. */
  private readonly warnOnce = (sentence: string): void => {
    if (!this.warnings.has(sentence)) console.warn(sentence);
    this.warnings.add(sentence);
  };

  private remove(client: TaskClient): void {
    this.clients.splice(this.clients.indexOf(client), 1);
    if (this.clients.length === 0) this.onIdle();
  }
}
