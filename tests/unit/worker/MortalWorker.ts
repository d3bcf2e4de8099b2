import { runSliced } from '../../../src/mesh/runSliced.js';
import type { ToWorker } from '../../../src/worker/protocol.js';
import type { AnyTask } from '../../../src/worker/TaskSet.js';
import { type BakingTasks, tasks } from '../../../src/worker/tasks.js';
import { FakeWorker } from './FakeWorker.js';

/** A worker that runs its tasks, but dies of some. */
export class MortalWorker extends FakeWorker {
  /** @param isDeadly whether it dies of a task */
  constructor(private readonly isDeadly: (task: keyof BakingTasks) => boolean) {
    super();
    queueMicrotask(() => this.say({ type: 'ready' }));
  }

  override postMessage(message: ToWorker, transfer: Transferable[]): void {
    super.postMessage(message, transfer);
    if (message.type !== 'run') return;
    const { id, task } = message;
    if (this.isDeadly(task as keyof BakingTasks)) queueMicrotask(() => this.onerror?.({ message: `of ${task}` }));
    else void this.work(id, task as keyof BakingTasks, (this.received.at(-1) as { request: unknown }).request);
  }

  private async work(id: number, task: keyof BakingTasks, request: unknown): Promise<void> {
    const result = await runSliced((tasks[task] as unknown as AnyTask).run(request));
    this.say({ type: 'done', id, result: structuredClone(result) });
  }
}
