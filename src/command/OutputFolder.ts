import { randomBytes } from 'node:crypto';
import { mkdir, readdir, rename, rm, rmdir, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { MapFile } from '../mapFiles/mapFiles.js';
import { UsageError } from './parseArguments.js';
import { sentenceOf } from './sentenceOf.js';

/** Whether a file name is one of a saved map. */
const isMapFile = (name: string): boolean => /^(map\.json|(tone-\d+|thresholds)-level-\d+\.png)$/.test(name);

/** What the name of a folder within begins with where files lie until all are written. */
const DRAFT = '.three-hatching-';

/**
 * The folder that a map goes into. Whatever may go wrong shows in `open`, before anything is drawn. All files of a map are
 * written or none, and nothing else in the folder is touched. The folder itself stays, be it a link or a disk of its own.
 */
export class OutputFolder {
  /** Folders that were made, the outermost first. */
  private readonly made: string[] = [];
  private readonly draft: string;
  private isWritten = false;

  /**
   * @param folder as it was named; may not exist yet
   * @param mayReplace whether a map that is there may be replaced
   */
  constructor(
    private readonly folder: string,
    private readonly mayReplace: boolean,
  ) {
    this.draft = join(folder, `${DRAFT}${randomBytes(4).toString('hex')}`);
  }

  /**
   * Makes the folder if it is missing and tries whether so many bytes can be written there. To be closed whatever happens.
   *
   * @throws UsageError with one sentence
   */
  async open(bytes: number): Promise<void> {
    try {
      await this.make(this.folder);
      await this.mapFilesThere();
      await mkdir(this.draft);
      const probe = join(this.draft, 'room');
      await writeFile(probe, Buffer.alloc(bytes));
      await rm(probe);
    } catch (error) {
      throw error instanceof UsageError ? error : new UsageError(sentenceOf(this.folder, error));
    }
  }

  /**
   * Writes all files, and takes away those of the map that was there.
   *
   * @throws the signal's reason if it aborts, or an Error with one sentence; all is as before then
   */
  async write(files: readonly MapFile[], signal: AbortSignal): Promise<void> {
    const { folder, draft } = this;
    try {
      const old = join(draft, 'old');
      await mkdir(old);
      for (const { name, bytes } of files) {
        signal.throwIfAborted();
        await writeFile(join(draft, name), bytes);
      }
      signal.throwIfAborted();
      // Others may have written there while the map was drawn.
      const replaced = await this.mapFilesThere();
      await moveAll([
        ...replaced.map((name) => [join(folder, name), join(old, name)] as const),
        ...files.map(({ name }) => [join(draft, name), join(folder, name)] as const),
      ]);
      this.isWritten = true;
    } catch (error) {
      if (signal.aborted || error instanceof UsageError) throw error;
      throw new Error(sentenceOf(folder, error));
    }
  }

  /** Takes away what was only needed on the way, and the folders that were made in vain. */
  async close(): Promise<void> {
    await rm(this.draft, { recursive: true, force: true }).catch(() => {});
    if (this.isWritten) return;
    // One that is not empty has become somebody else's.
    for (const folder of this.made.toReversed()) await rmdir(folder).catch(() => {});
  }

  /** Not `mkdir` with `recursive`: below /proc Node tries that for ever. */
  private async make(path: string): Promise<void> {
    if (await isFolder(path)) return;
    const parent = dirname(path);
    try {
      if (parent !== path) await this.make(parent);
      await mkdir(path);
    } catch (error) {
      throw error instanceof UsageError ? error : new UsageError(sentenceOf(path, error));
    }
    this.made.push(path);
  }

  /** @throws UsageError if there is anything but the files of a map, or a map that may not be replaced */
  private async mapFilesThere(): Promise<string[]> {
    const { folder } = this;
    const entries = (await readdir(folder, { withFileTypes: true })).filter(({ name }) => !name.startsWith(DRAFT));
    const other = entries.find((entry) => !(entry.isFile() && isMapFile(entry.name)));
    if (other) {
      throw new UsageError(`${folder} holds other files (${other.name}); choose a folder of its own after --out.`);
    }
    if (entries.length > 0 && !this.mayReplace) {
      throw new UsageError(`${folder} holds a map already; add --force to replace it, or choose another folder.`);
    }
    return entries.map(({ name }) => name);
  }
}

/** Whether there is a folder of that name. @throws UsageError if there is something else, or it cannot be known */
async function isFolder(path: string): Promise<boolean> {
  try {
    if ((await stat(path)).isDirectory()) return true;
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    // Below a file too, which is found on the way up.
    if (code === 'ENOENT' || code === 'ENOTDIR') return false;
    throw new UsageError(sentenceOf(path, error));
  }
  throw new UsageError(`${path} is not a folder; choose another name after --out.`);
}

/** Moves all files, or none if one cannot be moved. */
async function moveAll(moves: readonly (readonly [from: string, to: string])[]): Promise<void> {
  const done: (readonly [string, string])[] = [];
  try {
    for (const [from, to] of moves) {
      await rename(from, to);
      done.push([from, to]);
    }
  } catch (error) {
    for (const [from, to] of done.toReversed()) await rename(to, from);
    throw error;
  }
}
