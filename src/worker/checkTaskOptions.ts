import type { TaskOptions } from './TaskOptions.js';

/**
 * Checks what plain JavaScript may get wrong in the options of a task.
 *
 * @param caller the public function, for the message
 * @throws TypeError naming the option and what it must be
 */
export function checkTaskOptions(caller: string, options: TaskOptions): void {
  if (typeof options !== 'object' || options === null) {
    throw new TypeError(`${caller}: options is ${String(options)}, but must be an object, or left out.`);
  }
  const { signal, onProgress, createWorker } = options;
  if (isGiven(signal) && !isSignal(signal)) {
    throw new TypeError(`${caller}: signal must be an AbortSignal, such as the signal of a new AbortController().`);
  }
  for (const [name, value] of Object.entries({ onProgress, createWorker })) {
    if (!isGiven(value) || typeof value === 'function') continue;
    throw new TypeError(`${caller}: ${name} must be a function, or left out.`);
  }
}

/** null stands for left out, as for `fetch`. */
const isGiven = <Value>(value: Value | null | undefined): value is Value => value !== undefined && value !== null;

/** Not `instanceof`: a signal may come from another frame. */
const isSignal = (signal: Partial<AbortSignal>): boolean =>
  typeof signal.aborted === 'boolean' && typeof signal.throwIfAborted === 'function';
