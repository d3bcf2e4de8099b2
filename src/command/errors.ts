/** A mistake in the command line, reported without a stack trace. */
export class UsageError extends Error {}

/** The user interrupted the command. The message says how many files were written. */
export class Interrupted extends Error {
  /** @param written number of files written before the interruption */
  constructor(written = 0) {
    const files = written === 1 ? '1 file was' : `${written} files were`;
    super(`interrupted; ${written === 0 ? 'nothing was written' : `${files} written before that`}.`);
  }
}
