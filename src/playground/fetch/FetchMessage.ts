/** A message from the fetching page to the playground. */
export type FetchMessage =
  | { kind: 'ready' }
  | { kind: 'progress'; bytes: number; total: number | undefined }
  | { kind: 'done'; content: Blob }
  /** The server answered with an HTTP error. */
  | { kind: 'refused'; status: number }
  | { kind: 'too large' }
  /** The server redirected to another site, to which the user has not agreed. */
  | { kind: 'redirected' }
  /** The request failed. Browsers do not tell scripts why. */
  | { kind: 'failed' };
