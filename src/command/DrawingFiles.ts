import { randomBytes } from 'node:crypto';
import { rename, rm, rmdir, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { makeFolder } from './makeFolder.js';
import { sentenceOf } from './sentenceOf.js';
import { STANDARD, writeStandardOutput } from './standardStreams.js';
import { UsageError } from './UsageError.js';

/**
 * Writes drawings. Each file is there as a whole or not at all: it gets its name when all of it is written. The path `-` is the standard
 * output.
 */
export class DrawingFiles {
  /** The folders that were created, the outermost first. */
  private readonly made: string[] = [];
  /** Files that are being written, under names for the meantime. */
  private readonly drafts = new Set<string>();
  /** How many files were written. */
  written = 0;

  /** @param mayReplace whether files that are there may be replaced */
  constructor(private readonly mayReplace: boolean) {}

  /**
   * Creates the folders of files, and looks whether the files may be written. Call `close` afterwards in any case.
   *
   * @throws UsageError whose message is a single sentence
   */
  async open(outputs: readonly string[]): Promise<void> {
    const paths = outputs.filter((path) => path !== STANDARD);
    for (const folder of new Set(paths.map((path) => dirname(path)))) await makeFolder(folder, this.made);
    for (const path of paths) await this.check(path);
  }

  /**
   * Writes a file.
   *
   * @throws Error whose message is a single sentence, if it cannot be written; there is none of it then
   */
  async write(path: string, text: string): Promise<void> {
    if (path === STANDARD) await writeStandardOutput(text);
    else await this.writeFile(path, text);
    this.written++;
  }

  private async writeFile(path: string, text: string): Promise<void> {
    const draft = join(dirname(path), `.three-hatching-${randomBytes(4).toString('hex')}`);
    this.drafts.add(draft);
    try {
      await writeFile(draft, text);
      // Another program may have written it meanwhile.
      await this.check(path);
      await rename(draft, path);
    } catch (error) {
      await rm(draft, { force: true }).catch(() => {});
      throw error instanceof UsageError ? error : new Error(sentenceOf(path, error));
    } finally {
      this.drafts.delete(draft);
    }
  }

  /** Removes what was not written to the end, and the folders that were created if nothing was written. */
  async close(): Promise<void> {
    for (const draft of this.drafts) await rm(draft, { force: true }).catch(() => {});
    if (this.written > 0) return;
    // A folder that is not empty is kept, because another program has used it.
    for (const folder of this.made.toReversed()) await rmdir(folder).catch(() => {});
  }

  private async check(path: string): Promise<void> {
    const found = await stat(path).catch((error: NodeJS.ErrnoException) => {
      if (error.code === 'ENOENT') return undefined;
      throw new UsageError(sentenceOf(path, error));
    });
    if (found && !found.isFile()) throw new UsageError(`${path} is no file; choose another name after --out.`);
    if (found && !this.mayReplace)
      throw new UsageError(`${path} is there already; add --force to replace it, or choose another name after --out.`);
  }
}
