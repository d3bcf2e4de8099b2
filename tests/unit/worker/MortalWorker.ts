import { runSliced } from '../../../src/slices/runSliced.js';
import type { ToWorker } from '../../../src/worker/protocol.js';
import { type TaskName, taskNamed } from '../../../src/worker/tasks.js';
import { FakeWorker } from './FakeWorker.js';

/** A worker that does its tasks, but dies of some. */
export class MortalWorker extends FakeWorker {
  /** @param isDeadly whether it dies of a task */
  constructor(private readonly isDeadly: (task: TaskName) => boolean) {
    super();
    queueMicrotask(() => this.say({ type: 'ready' }));
  }

  override postMessage(message: ToWorker, transfer: Transferable[]): void {
    super.postMessage(message, transfer);
    if (message.type !== 'run') return;
    const { id, task } = message;
    if (this.isDeadly(task)) queueMicrotask(() => this.onerror?.({ message: `of ${task}` }));
    else void this.work(id, task, (this.received.at(-1) as { request: unknown }).request);
  }

  private async work(id: number, task: TaskName, request: unknown): Promise<void> {
    const result = await runSliced(taskNamed(task).run(request));
    this.say({ type: 'done', id, result: structuredClone(result) });
  }
}
