/** The error of a request that was pending when its worker was disposed of. */
export const disposedError = (): Error =>
  new Error('The hatching worker was disposed of before this request was finished. Ask again if you still need it.');
