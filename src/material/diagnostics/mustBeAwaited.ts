import { warn } from './warn.js';

/**
 * Makes a promise warn, once, that an `await` is missing when a property of its result is read from the promise itself.
 *
 * @param call the function that returns the promise
 * @param members properties of the result that a caller without `await`, or three.js, would read first
 */
export function mustBeAwaited<Result>(
  promise: Promise<Result>,
  call: string,
  members: readonly (keyof Result & string)[],
): Promise<Result> {
  let hasWarned = false;
  for (const member of members) {
    Object.defineProperty(promise, member, {
      get() {
        if (!hasWarned) warn(`${call} returns a promise, which has no "${member}". Write await before the call.`);
        hasWarned = true;
      },
    });
  }
  return promise;
}

/** Whether a value is a promise, that is, whether an `await` is missing. */
export const isPromise = (value: unknown): boolean =>
  typeof (value as Partial<Promise<unknown>> | null | undefined)?.then === 'function';
