import { mkdir, stat } from 'node:fs/promises';
import { dirname } from 'node:path';
import { sentenceOf } from './sentenceOf.js';
import { UsageError } from './UsageError.js';

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
