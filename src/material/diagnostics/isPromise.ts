/** Whether a value is a promise, that is, whether an `await` is missing. */
export const isPromise = (value: unknown): boolean =>
  typeof (value as Partial<Promise<unknown>> | null | undefined)?.then === 'function';
