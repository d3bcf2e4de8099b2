import { randomBytes } from 'node:crypto';
import { mkdir, readdir, rename, rm, rmdir, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { MapFile } from '../strokes/mapFiles/mapFiles.js';
import { UsageError } from './readOptions.js';

/** Whether a file name is one of those of a saved map. */
const isMapFile = (name: string): boolean => /^(map\.json|(tone-\d+|thresholds)-level-\d+\.png)$/.test(name);

/** Prefix of the temporary folder that holds the files until all are written. */
const DRAFT = '.three-hatching-';

/**
 * The output folder of a map. `open` finds most faults before anything is drawn. `write` writes all files of a map or none, and leaves
 * other files alone. The folder itself is never replaced, since it may be a link or a mount point.
 */
export class OutputFolder {
  /** The folders that were created, outermost first. */
  private readonly made: string[] = [];
  private readonly draft: string;
  private isWritten = false;

  /**
   * @param folder path of the folder, which need not exist
   * @param mayReplace whether an existing map may be replaced
   */
  constructor(
    private readonly folder: string,
    private readonly mayReplace: boolean,
  ) {
    this.draft = join(folder, `${DRAFT}${randomBytes(4).toString('hex')}`);
  }

  /**
   * Creates the folder if it is missing, and checks that `bytes` bytes can be written there. Call `close` afterwards in any case.
   *
   * @throws UsageError whose message is a single sentence
   */
  async open(bytes: number): Promise<void> {
    try {
      await makeFolder(this.folder, this.made);
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
   * Writes all files, and removes those of the previous map.
   *
   * @throws the signal's reason when aborted, or an Error whose message is a single sentence. The folder is unchanged then.
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
      // Another program may have written files there since `open`.
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

  /** Removes temporary files, and the created folders if nothing was written. */
  async close(): Promise<void> {
    await rm(this.draft, { recursive: true, force: true }).catch(() => {});
    if (this.isWritten) return;
    // `rmdir` fails where another program has put files, and the folder stays.
    for (const folder of this.made.toReversed()) await rmdir(folder).catch(() => {});
  }

  /**
   * The names of the map files in the folder.
   *
   * @throws UsageError if the folder has other files, or a map that may not be replaced
   */
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

/** Moves all files, or none if one fails. */
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

/**
 * Creates a folder and its parents. `mkdir` with `recursive` would never return below /proc.
 *
 * @param made receives the paths of created folders, outermost first
 * @throws UsageError whose message is a single sentence
 */
export async function makeFolder(path: string, made: string[]): Promise<void> {
  if (await isFolder(path)) return;
  const parent = dirname(path);
  try {
    if (parent !== path) await makeFolder(parent, made);
    await mkdir(path);
  } catch (error) {
    throw error instanceof UsageError ? error : new UsageError(sentenceOf(path, error));
  }
  made.push(path);
}

/**
 * Whether a path is a folder.
 *
 * @throws UsageError if it is something else, or cannot be read
 */
async function isFolder(path: string): Promise<boolean> {
  try {
    if ((await stat(path)).isDirectory()) return true;
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    // ENOTDIR: the path lies below a file, which `makeFolder` reports when it reaches it.
    if (code === 'ENOENT' || code === 'ENOTDIR') return false;
    throw new UsageError(sentenceOf(path, error));
  }
  throw new UsageError(`${path} is not a folder; choose another name after --out.`);
}

/** Messages for error codes of the file system, about a folder. */
const MEANINGS: Readonly<Record<string, string>> = {
  EACCES: 'may not be written to; change its permissions, or choose another folder after --out',
  EPERM: 'may not be written to; change its permissions, or choose another folder after --out',
  EROFS: 'lies on a read-only disk; choose another folder after --out',
  ENOSPC: 'lies on a disk that is full; make room there, or choose another folder after --out',
  EDQUOT: 'lies where there is no room left for you; make room there, or choose another folder after --out',
  ENOENT: 'cannot be made there; choose another folder after --out',
  ENOTDIR: 'is not a folder; choose another name after --out',
  EEXIST: 'is a link that leads nowhere, or not a folder; choose another name after --out',
  ENAMETOOLONG: 'has too long a name; choose a shorter one after --out',
  ELOOP: 'is a link that leads to itself; choose another name after --out',
};

/** Describes an error of the file system in a sentence. Other errors keep their messages. */
export function sentenceOf(path: string, error: unknown): string {
  const { code, message } = error as NodeJS.ErrnoException;
  if (code === undefined) return message;
  const shown = path.length > 160 ? `${path.slice(0, 80)}…${path.slice(-60)}` : path;
  return `${shown} ${MEANINGS[code] ?? `could not be written (${code}); choose another folder after --out`}.`;
}
