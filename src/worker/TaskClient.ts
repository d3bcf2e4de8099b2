import { runSliced, type SlicedOptions } from '../mesh/runSliced.js';
import { awaitEnd, type FromWorker, type ToWorker, unpackError } from './protocol.js';
import { SILENCE_SECONDS, SilenceWatch } from './SilenceWatch.js';
import type { AnyTask, NameIn, RequestOf, ResultOf, TaskSet, Tasks } from './TaskSet.js';

/** Milliseconds after which an idle worker is terminated, because it holds a thread and tens of megabytes. */
const IDLE_MS = 10_000;

/** Milliseconds to wait for a new worker's `ready` before falling back to the main thread. */
const START_MS = 15_000;

/** After a task has died with this many workers, it runs on the main thread. */
const MAX_DEATHS = 2;

/** Makes a request again after its buffers were lost with a worker. */
export type MakeAgain<Request> = () => Request | Promise<Request>;

/** A request whose promise is pending. */
interface Pending {
  id: number;
  task: string;
  request: unknown;
  makeAgain: MakeAgain<unknown> | undefined;
  /** Where the request is. `lost`: its buffers are gone, and the request is being made again. */
  place: 'waiting' | 'worker' | 'mainThread' | 'lost';
  /** The number of workers that have died while they ran the request. */
  deaths: number;
  /** Highest progress reported so far. */
  progress: number;
  options: SlicedOptions;
  resolve(result: unknown): void;
  reject(reason: unknown): void;
  /** Stops listening to the signal and, if the task runs on the main thread, stops the task. */
  release(): void;
}

/** `starting`: the worker has not yet sent `ready`. `unavailable`: there can be no worker, so tasks run on the main thread. */
type State = 'none' | 'starting' | 'ready' | 'unavailable';

/**
 * Runs tasks in one worker. The worker starts with the first request, and is terminated after it has been idle for a while.
 *
 * - Any number of requests may be pending; the worker interleaves them.
 * - If there is no `Worker`, or a Content-Security-Policy forbids it (which shows as an exception or as an error event), the
 *   tasks run in slices on the main thread. Requests are posted only after the worker has sent `ready`, so a worker that never
 *   starts loses nothing.
 * - When a running worker dies, the buffers of its requests are lost with it. Requests that can be made again start over in a
 *   new worker and, if that dies too, on the main thread; the others are rejected. The client learns of a death from an event,
 *   from the lock that the worker held, or from its silence.
 */
export class TaskClient<All extends Tasks> {
  private worker: Worker | null = null;
  private state: State = 'none';
  private nextId = 0;
  private readonly pending = new Map<number, Pending>();
  /** While starting: the time limit for `ready`. While idle: the time until the worker is terminated. */
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Stops waiting for the lock that the worker holds. */
  private forgetLock: () => void = () => {};
  /** Watches a worker while it has work to do. */
  private readonly watch = new SilenceWatch(
    () => this.send({ type: 'ping' }),
    () => this.onWorkerError(`it gave no sign of life for ${SILENCE_SECONDS} s`),
  );

  /**
   * @param set the tasks that the worker can run
   * @param createWorker creates the worker, or returns null if there is none; may throw.
   * @param onIdle called after an idle worker was terminated.
   * @param warn called with a sentence when no worker could be started, or when a worker has died.
   */
  constructor(
    private readonly set: TaskSet<All>,
    private readonly createWorker: () => Worker | null,
    private readonly onIdle: () => void = () => {},
    private readonly warn: (sentence: string) => void = (sentence) => console.warn(sentence),
  ) {}

  /** The number of pending requests. */
  get pendingCount(): number {
    return this.pending.size;
  }

  /** Whether no worker can be started, so that tasks run on the main thread. */
  get isUnavailable(): boolean {
    return this.state === 'unavailable';
  }

  /**
   * Runs a task. The buffers of `request` are transferred: pass copies of what you want to keep. Rejects with the signal's
   * reason when aborted, with the task's error, with an Error when the worker is disposed of, or with a TypeError when
   * `createWorker` returns no Worker.
   *
   * @param makeAgain makes the same request again. Without it, or if it fails, the promise is rejected with an Error when the
   *   worker dies.
   */
  run<Name extends NameIn<All>>(
    task: Name,
    request: RequestOf<All, Name>,
    options: SlicedOptions = {},
    makeAgain?: MakeAgain<RequestOf<All, Name>>,
  ): Promise<ResultOf<All, Name>> {
    const { signal } = options;
    if (signal?.aborted) return Promise.reject(signal.reason);
    return new Promise<ResultOf<All, Name>>((resolve, reject) => {
      // An exception in here rejects the promise.
      this.start();
      const id = this.nextId++;
      const onAbort = () => {
        this.send({ type: 'abort', id });
        this.settle(id)?.reject(signal!.reason);
      };
      signal?.addEventListener('abort', onAbort);
      const release = () => signal?.removeEventListener('abort', onAbort);
      const entry: Pending = {
        id,
        task,
        request,
        makeAgain,
        place: 'waiting',
        deaths: 0,
        progress: 0,
        options,
        resolve,
        reject,
        release,
      };
      this.pending.set(id, entry);
      this.begin(entry);
    });
  }

  /** Terminates the worker and rejects all pending requests. The client stays usable: the next request starts a new worker. */
  dispose(): void {
    this.fail(disposedError());
  }

  /** Starts the worker, unless it runs. @throws TypeError when `createWorker` returns no Worker */
  start(): void {
    if (this.state === 'ready') clearTimeout(this.timer);
    if (this.state !== 'none') return;
    try {
      this.worker = this.createWorker();
    } catch (error) {
      this.fallBack(error);
      return;
    }
    if (this.worker === null) {
      this.state = 'unavailable';
      return;
    }
    this.assertWorker(this.worker);
    this.state = 'starting';
    this.timer = setTimeout(() => this.fallBack(`it did not report within ${START_MS / 1000} s`), START_MS);
    const { worker } = this;
    worker.onmessage = (event: MessageEvent<FromWorker>) => this.receive(event.data);
    worker.onmessageerror = () => this.onWorkerError('a message could not be read');
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.onWorkerError(event.message || 'its script could not be loaded');
    };
  }

  private assertWorker(made: Worker): void {
    if (typeof made?.postMessage === 'function' && typeof made.terminate === 'function') return;
    this.worker = null;
    const kind = made instanceof Promise ? 'a Promise' : made === undefined ? 'nothing' : 'something else';
    throw new TypeError(
      `createWorker must return a Worker, but returned ${kind}; pass a plain function such as () => new Worker(url, { type: 'module' }).`,
    );
  }

  private receive(message: FromWorker): void {
    this.watch.hear();
    if (message.type === 'ready') {
      clearTimeout(this.timer);
      this.state = 'ready';
      if (message.lock) this.forgetLock = awaitEnd(message.lock, () => this.onWorkerError('it has ended'));
      this.beginAll();
      this.startIdleTimer();
    } else if (message.type === 'alive') {
      // The watch has already registered it.
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

  private beginAll(): void {
    for (const entry of this.pending.values()) this.begin(entry);
  }

  /** Runs a waiting request, unless the worker is still starting. */
  private begin(entry: Pending): void {
    if (entry.place !== 'waiting') return;
    if (this.state === 'unavailable' || entry.deaths >= MAX_DEATHS) this.runOnMainThread(entry);
    else if (this.state === 'ready') this.dispatch(entry);
  }

  private dispatch(entry: Pending): void {
    const { id, task, request } = entry;
    entry.place = 'worker';
    // Its buffers are about to be transferred, so there is nothing left to keep.
    entry.request = undefined;
    this.watch.start();
    try {
      this.send({ type: 'run', id, task, request }, this.set.requestBuffers[task](request as never));
    } catch (error) {
      this.settle(id)?.reject(error);
    }
  }

  private runOnMainThread(entry: Pending): void {
    const { id, task, request, release } = entry;
    entry.place = 'mainThread';
    const controller = new AbortController();
    entry.release = () => {
      release();
      controller.abort();
    };
    const onProgress = (progress: number) => this.report(id, progress);
    this.set
      .fetchTasks()
      .then(async (tasks) => {
        const { [task]: present } = tasks as unknown as Record<string, AnyTask>;
        await present.prepare?.(request);
        return runSliced(present.run(request), { signal: controller.signal, onProgress });
      })
      .then(
        (result) => this.finish(id, result),
        (error) => this.settle(id)?.reject(error),
      );
  }

  /** The worker did not start: this and all later tasks run on the main thread. */
  private fallBack(reason: unknown): void {
    const text = reason instanceof Error ? reason.message : String(reason);
    this.warn(
      `three-hatching: the worker could not be started (${text}). The main thread computes instead, in slices; under a Content-Security-Policy pass createWorker.`,
    );
    this.end('unavailable');
    this.beginAll();
  }

  private onWorkerError(reason: string): void {
    if (this.state === 'starting') {
      this.fallBack(reason);
      return;
    }
    this.end('none');
    const lost = [...this.pending.values()].filter(({ place }) => place === 'worker');
    const death = new Error(
      `The hatching worker died (${reason}) before this request was finished. Ask again; a new worker will be started.`,
    );
    for (const entry of lost) this.startAgain(entry, death);
    if (!lost.some(({ makeAgain }) => makeAgain)) return;
    const isLast = lost.some(({ deaths }) => deaths >= MAX_DEATHS);
    this.warn(
      `three-hatching: the worker died (${reason}). ${isLast ? 'Its tasks start over on the main thread, in slices.' : 'Its tasks start over in a new worker.'}`,
    );
  }

  /** Makes a request again that was lost with a worker, and runs it: in a new worker after the first death, else on the main thread. */
  private async startAgain(entry: Pending, death: Error): Promise<void> {
    entry.place = 'lost';
    entry.deaths++;
    try {
      if (!entry.makeAgain) throw death;
      entry.request = await entry.makeAgain();
      if (!this.pending.has(entry.id)) return;
      if (entry.deaths < MAX_DEATHS) this.start();
      entry.place = 'waiting';
      this.begin(entry);
    } catch (cause) {
      if (cause !== death) death.cause ??= cause;
      this.settle(entry.id)?.reject(death);
    }
  }

  /** Terminates the worker and rejects all pending requests. */
  private fail(error: Error): void {
    this.end('none');
    for (const id of [...this.pending.keys()]) this.settle(id)?.reject(error);
  }

  private end(state: State): void {
    clearTimeout(this.timer);
    this.watch.stop();
    this.forgetLock();
    this.forgetLock = () => {};
    if (this.worker) {
      // Messages of the terminated worker may still arrive.
      this.worker.onmessage = this.worker.onmessageerror = this.worker.onerror = null;
      this.worker.terminate();
    }
    this.worker = null;
    this.state = state;
  }

  /** Removes a request from the pending ones and returns it, or undefined if it was settled before. */
  private settle(id: number): Pending | undefined {
    const entry = this.pending.get(id);
    if (!entry) return undefined;
    this.pending.delete(id);
    entry.release();
    this.startIdleTimer();
    return entry;
  }

  /** Starts the idle timer if the worker has nothing to do. */
  private startIdleTimer(): void {
    if (this.pending.size > 0 || this.state !== 'ready') return;
    this.watch.stop();
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

/** The error of a request that was pending when its worker was disposed of. */
export const disposedError = (): Error =>
  new Error('The hatching worker was disposed of before this request was finished. Ask again if you still need it.');
