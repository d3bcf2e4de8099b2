/** The user has interrupted the command. The message says what there is of its files. */
export class Interrupted extends Error {
  /** @param written how many files were written before that */
  constructor(written = 0) {
    const files = written === 1 ? '1 file was' : `${written} files were`;
    super(`interrupted; ${written === 0 ? 'nothing was written' : `${files} written before that`}.`);
  }
}
