import { runSliced, type SlicedOptions } from '../slices/runSliced.js';
import { type FromWorker, type ToWorker, unpackError } from './protocol.js';
import { type TaskName, type TaskRequest, type TaskResult, taskNamed } from './tasks.js';

/** A worker without work is ended after this time. It holds a thread and tens of megabytes. */
const IDLE_MS = 10_000;

/** A worker that has not said `ready` after this time is given up. */
const START_MS = 15_000;

/** A request whose promise is open. */
interface Pending {
  id: number;
  task: TaskName;
  request: unknown;
  /** Highest progress reported so far. */
  progress: number;
  options: SlicedOptions;
  resolve(result: unknown): void;
  reject(reason: unknown): void;
  /** Stops listening to the signal, and computing, if that happens here. */
  release(): void;
}

/** `starting`: waits for `ready`. `unavailable`: no worker can be had, the main thread computes. */
type State = 'none' | 'starting' | 'ready' | 'unavailable';

/**
 * Runs tasks in one worker, which starts with the first request and ends when it has been idle for a while.
 *
 * - Any number of requests may be open; the worker lets them take turns.
 * - Where no worker can be had (no `Worker`, or a Content-Security-Policy forbids it, at once or by an error event),
 *   the tasks run in slices on the main thread. Requests leave for the worker only after it has reported `ready`, so
 *   nothing is lost with a worker that never starts.
 * - When a worker that has started dies, the open promises are rejected (their buffers died with it), and the next
 *   request starts a new worker.
 */
export class TaskClient {
  private worker: Worker | null = null;
  private state: State = 'none';
  private nextId = 0;
  private readonly pending = new Map<number, Pending>();
  /** Waits for `ready` while starting; for the end of idleness while ready and without work. */
  private timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * @param createWorker makes the worker, or returns null where there are none; may throw.
   * @param onIdle called when the worker has been ended because there was nothing to do.
   */
  constructor(
    private readonly createWorker: () => Worker | null,
    private readonly onIdle: () => void = () => {},
  ) {}

  /**
   * Runs a task. The buffers of `request` are transferred: pass copies of what you want to keep. Rejects with the
   * signal's reason when aborted, with the task's error, or with an Error when the worker dies or is disposed of.
   */
  run<Name extends TaskName>(
    task: Name,
    request: TaskRequest<Name>,
    options: SlicedOptions = {},
  ): Promise<TaskResult<Name>> {
    const { signal } = options;
    if (signal?.aborted) return Promise.reject(signal.reason);
    return new Promise<unknown>((resolve, reject) => {
      this.start();
      const id = this.nextId++;
      const onAbort = () => {
        this.send({ type: 'abort', id });
        this.settle(id)?.reject(signal!.reason);
      };
      signal?.addEventListener('abort', onAbort);
      const release = () => signal?.removeEventListener('abort', onAbort);
      const entry: Pending = { id, task, request, progress: 0, options, resolve, reject, release };
      this.pending.set(id, entry);
      if (this.state === 'ready') this.dispatch(entry);
      else if (this.state === 'unavailable') this.runHere(entry);
    }) as Promise<TaskResult<Name>>;
  }

  /** Ends the worker and rejects what is pending. The client may be used again; it then starts a new worker. */
  dispose(): void {
    this.fail(
      new Error(
        'The hatching worker was disposed of before this request was finished. Ask again if you still need it.',
      ),
    );
  }

  private start(): void {
    if (this.state === 'ready') clearTimeout(this.timer);
    if (this.state !== 'none') return;
    try {
      this.worker = this.createWorker();
    } catch (error) {
      this.giveUp(error);
      return;
    }
    if (!this.worker) {
      this.state = 'unavailable';
      return;
    }
    this.state = 'starting';
    this.timer = setTimeout(() => this.giveUp(`it did not report within ${START_MS / 1000} s`), START_MS);
    const { worker } = this;
    worker.onmessage = (event: MessageEvent<FromWorker>) => this.receive(event.data);
    worker.onmessageerror = () => this.onDeath('a message could not be read');
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.onDeath(event.message || 'its script could not be loaded');
    };
  }

  private receive(message: FromWorker): void {
    if (message.type === 'ready') {
      clearTimeout(this.timer);
      this.state = 'ready';
      for (const entry of this.pending.values()) this.dispatch(entry);
      this.rest();
    } else if (message.type === 'progress') {
      this.report(message.id, message.progress);
    } else if (message.type === 'done') {
      this.finish(message.id, message.result);
    } else {
      this.settle(message.id)?.reject(unpackError(message.error));
    }
  }

  private report(id: number, progress: number): void {
    const entry = this.pending.get(id);
    if (!entry || progress <= entry.progress) return;
    entry.progress = progress;
    try {
      entry.options.onProgress?.(progress);
    } catch (error) {
      this.send({ type: 'abort', id });
      this.settle(id)?.reject(error);
    }
  }

  private finish(id: number, result: unknown): void {
    this.report(id, 1);
    this.settle(id)?.resolve(result);
  }

  private dispatch({ id, task, request }: Pending): void {
    try {
      this.send({ type: 'run', id, task, request }, taskNamed(task).requestBuffers(request));
    } catch (error) {
      this.settle(id)?.reject(error);
    }
  }

  private runHere(entry: Pending): void {
    const { id, task, request, release } = entry;
    const controller = new AbortController();
    entry.release = () => {
      release();
      controller.abort();
    };
    const onProgress = (progress: number) => this.report(id, progress);
    runSliced(taskNamed(task).run(request), { signal: controller.signal, onProgress }).then(
      (result) => this.finish(id, result),
      (error) => this.settle(id)?.reject(error),
    );
  }

  /** The worker never started: compute here, now and from now on. */
  private giveUp(reason: unknown): void {
    const text = reason instanceof Error ? reason.message : String(reason);
    console.warn(
      `three-hatching: the worker could not be started (${text}). The main thread computes instead, in slices; under a Content-Security-Policy pass createWorker.`,
    );
    this.end('unavailable');
    for (const entry of this.pending.values()) this.runHere(entry);
  }

  private onDeath(reason: string): void {
    if (this.state === 'starting') {
      this.giveUp(reason);
      return;
    }
    this.fail(
      new Error(
        `The hatching worker died (${reason}) before this request was finished. Ask again; a new worker will be started.`,
      ),
    );
  }

  /** Ends the worker and rejects everything that is open. */
  private fail(error: Error): void {
    this.end('none');
    for (const id of [...this.pending.keys()]) this.settle(id)?.reject(error);
  }

  private end(state: State): void {
    clearTimeout(this.timer);
    if (this.worker) {
      // What an ended worker has sent may still be on its way.
      this.worker.onmessage = this.worker.onmessageerror = this.worker.onerror = null;
      this.worker.terminate();
    }
    this.worker = null;
    this.state = state;
  }

  /** Takes the request off the list; undefined if it was settled before. */
  private settle(id: number): Pending | undefined {
    const entry = this.pending.get(id);
    if (!entry) return undefined;
    this.pending.delete(id);
    entry.release();
    this.rest();
    return entry;
  }

  private rest(): void {
    if (this.pending.size > 0 || this.state !== 'ready') return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.end('none');
      this.onIdle();
    }, IDLE_MS);
  }

  private send(message: ToWorker, transfer: Transferable[] = []): void {
    if (this.state === 'ready') this.worker?.postMessage(message, transfer);
  }
}
