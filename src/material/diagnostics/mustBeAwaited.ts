import { warn } from './warn.js';

/**
 * Lets a promise say, once, that an `await` is missing, when a member of its result is asked of the promise itself.
 *
 * @param call the function that returns the promise
 * @param members what a caller without `await`, or three.js, would ask for first
 */
export function mustBeAwaited<Result>(
  promise: Promise<Result>,
  call: string,
  members: readonly (keyof Result & string)[],
): Promise<Result> {
  let wasTold = false;
  for (const member of members) {
    Object.defineProperty(promise, member, {
      get() {
        if (!wasTold) warn(`${call} returns a promise, which has no "${member}". Write await before the call.`);
        wasTold = true;
      },
    });
  }
  return promise;
}
