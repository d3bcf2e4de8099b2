/** A message from the page that fetches a file to the playground. */
export type FetchMessage =
  | { kind: 'ready' }
  | { kind: 'progress'; bytes: number; total: number | undefined }
  | { kind: 'done'; content: Blob }
  /** The server has answered, but not with a file. */
  | { kind: 'refused'; status: number }
  | { kind: 'too large' }
  /** The server has redirected to another site, to which the user has not agreed. */
  | { kind: 'redirected' }
  /** The request has failed. Browsers do not tell scripts why. */
  | { kind: 'failed' };
