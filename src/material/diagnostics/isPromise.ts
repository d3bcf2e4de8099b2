/** Whether an `await` is missing. */
export const isPromise = (value: unknown): boolean =>
  typeof (value as Partial<Promise<unknown>> | null | undefined)?.then === 'function';
