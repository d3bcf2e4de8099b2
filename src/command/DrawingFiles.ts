import { randomBytes } from 'node:crypto';
import { rename, rm, rmdir, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { makeFolder, sentenceOf } from './OutputFolder.js';
import { UsageError } from './readOptions.js';
import { STANDARD, writeStandardOutput } from './standardStreams.js';

/**
 * Writes drawings. Each file is complete or absent: it gets its final name once all of it is written. The path `-` is the standard output.
 */
export class DrawingFiles {
  /** The folders that were created, outermost first. */
  private readonly made: string[] = [];
  /** The temporary paths of files that are being written. */
  private readonly drafts = new Set<string>();
  /** The number of files written. */
  written = 0;

  /** @param mayReplace whether existing files may be replaced */
  constructor(private readonly mayReplace: boolean) {}

  /**
   * Creates the folders of the files, and checks that the files may be written. Call `close` afterwards in any case.
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
   * @throws Error whose message is a single sentence, if it cannot be written; no part of it is left then
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
      // Another program may have created it since `open`.
      await this.check(path);
      await rename(draft, path);
    } catch (error) {
      await rm(draft, { force: true }).catch(() => {});
      throw error instanceof UsageError ? error : new Error(sentenceOf(path, error));
    } finally {
      this.drafts.delete(draft);
    }
  }

  /** Removes incomplete files, and the created folders if nothing was written. */
  async close(): Promise<void> {
    for (const draft of this.drafts) await rm(draft, { force: true }).catch(() => {});
    if (this.written > 0) return;
    // `rmdir` fails where another program has put files, and the folder stays.
    for (const folder of this.made.toReversed()) await rmdir(folder).catch(() => {});
  }

  private async check(path: string): Promise<void> {
    const found = await stat(path).catch((error: NodeJS.ErrnoException) => {
      if (error.code === 'ENOENT') return undefined;
      throw new UsageError(sentenceOf(path, error));
    });
    if (found && !found.isFile()) throw new UsageError(`${path} is not a file; choose another name after --out.`);
    if (found && !this.mayReplace)
      throw new UsageError(`${path} is there already; add --force to replace it, or choose another name after --out.`);
  }
}
