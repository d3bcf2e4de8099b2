import { runSliced } from '../mesh/runSliced.js';
import { type FromWorker, holdLifeLock, packError, type ToWorker } from './protocol.js';
import { type AnyTask, buffersIn, type Tasks } from './TaskSet.js';

/** Milliseconds between two progress messages. A message after every slice took a twentieth of the time. */
const PROGRESS_MS = 40;

/** The members of a worker's global scope that are used here; TypeScript's DOM types describe only a window. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
}

/**
 * Makes this thread a worker that runs tasks. Requests run in slices, so that several can take turns and abort messages can arrive in
 * between.
 */
export function serveTasks(tasks: Tasks): void {
  const scope = globalThis as unknown as WorkerScope;
  const running = new Map<number, AbortController>();

  async function run({ id, task: name, request }: Extract<ToWorker, { type: 'run' }>): Promise<void> {
    const controller = new AbortController();
    running.set(id, controller);
    try {
      const task = tasks[name] as unknown as AnyTask | undefined;
      if (!task)
        throw new Error(
          `createWorker started a worker that cannot do this (${name}): drawSVG needs three-hatching/svg.worker, learnHandAsync and traceStrokes three-hatching/hand.worker, all else three-hatching/bake.worker.`,
        );
      await task.prepare?.(request);
      let said = -Infinity;
      const result = await runSliced(task.run(request), {
        signal: controller.signal,
        onProgress: (progress) => {
          const now = performance.now();
          if (now < said + PROGRESS_MS) return;
          said = now;
          scope.postMessage({ type: 'progress', id, progress });
        },
      });
      scope.postMessage({ type: 'done', id, result }, buffersIn(result));
    } catch (error) {
      if (!controller.signal.aborted) scope.postMessage({ type: 'failed', id, error: packError(error) });
    } finally {
      running.delete(id);
    }
  }

  scope.onmessage = ({ data }) => {
    if (data.type === 'abort') running.get(data.id)?.abort();
    else if (data.type === 'ping') scope.postMessage({ type: 'alive' });
    else void run(data);
  };

  holdLifeLock().then((lock) => scope.postMessage({ type: 'ready', lock }));
}
