/** What the page that fetches tells the playground. */
export type FetchMessage =
  | { kind: 'ready' }
  | { kind: 'progress'; bytes: number; total: number | undefined }
  | { kind: 'done'; content: Blob }
  /** The server has answered, but not with a file. */
  | { kind: 'refused'; status: number }
  | { kind: 'too large' }
  /** The server has named another one, which nobody has agreed to. */
  | { kind: 'sent on' }
  /** No answer came through: browsers do not tell scripts why. */
  | { kind: 'failed' };
