/** Options of every long task, whether it runs in a worker or in slices on the main thread. */
export interface TaskOptions {
  /** Aborting rejects the promise with the signal's reason and frees the task's memory. */
  signal?: AbortSignal | undefined;
  /** Called with rising values in [0, 1]. */
  onProgress?: ((progress: number) => void) | undefined;
  /**
   * Creates a worker. By default the library inlines its worker. If your Content-Security-Policy forbids that (`worker-src`
   * without `blob:`), create one from your own origin. With Vite for example:
   *
   *     import BakeWorker from 'three-hatching/bake.worker?worker';
   *     const createWorker = () => new BakeWorker();
   *
   * A function that returns anything but a Worker causes a TypeError. Requests with the same function share their workers (one
   * per core while there is work for them, four at most), so always pass the same function. If no worker can be started, tasks
   * run on the main thread in slices of a few milliseconds.
   */
  createWorker?: (() => Worker) | undefined;
}

/** The names of the options of every long task. */
const TASK_OPTIONS = { signal: true, onProgress: true, createWorker: true } satisfies Record<keyof TaskOptions, true>;

/**
 * Checks that `options` is an object with no names but those in `known`.
 *
 * @throws TypeError that names the caller, the fault and the known names
 */
export function checkNames(
  caller: string,
  what: string,
  options: unknown,
  known: Readonly<Record<string, true>>,
): void {
  const names = Object.keys(known).join(', ');
  if (typeof options !== 'object' || options === null) {
    throw new TypeError(`${caller}: the ${what} are ${String(options)}. Pass an object with some of ${names}.`);
  }
  for (const name of Object.keys(options)) {
    if (Object.hasOwn(known, name)) continue;
    throw new TypeError(`${caller}: unknown option "${name}". The known ones are ${names}.`);
  }
}

/**
 * Checks the names of all options, and the values of those in `TaskOptions`.
 *
 * @param own the names of the options that the caller adds to those of `TaskOptions`
 * @throws TypeError that names the caller, the option and its allowed values
 */
export function checkOptions(caller: string, options: TaskOptions, own: Readonly<Record<string, true>> = {}): void {
  checkNames(caller, 'options', options, { ...own, ...TASK_OPTIONS });
  const { signal, onProgress, createWorker } = options;
  if (isGiven(signal) && !isSignal(signal)) {
    throw new TypeError(
      `${caller}: signal is ${describe(signal)}, but must be an AbortSignal, such as the signal of an AbortController.`,
    );
  }
  for (const [name, value] of Object.entries({ onProgress, createWorker })) {
    if (!isGiven(value) || typeof value === 'function') continue;
    throw new TypeError(`${caller}: ${name} is ${describe(value)}, but must be a function, or left out.`);
  }
}

/** null counts as left out, as it does for `fetch`. */
const isGiven = <Value>(value: Value | null | undefined): value is Value => value !== undefined && value !== null;

/** `instanceof` would refuse a signal that comes from another frame. */
const isSignal = (signal: Partial<AbortSignal>): boolean =>
  typeof signal.aborted === 'boolean' && typeof signal.throwIfAborted === 'function';

const describe = (value: unknown): string =>
  typeof value === 'object' && value !== null ? `an object (${value.constructor?.name ?? 'Object'})` : String(value);

/** The largest number of workers at once. More would cost more memory than they save time. */
const MAX_WORKERS = 4;

/** The largest number of workers that a page uses: one per core, up to four. */
export function maxWorkers(): number {
  const cores = typeof navigator === 'undefined' ? 1 : navigator.hardwareConcurrency || 1;
  return Math.min(cores, MAX_WORKERS);
}
