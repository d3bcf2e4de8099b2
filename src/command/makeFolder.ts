import { mkdir, stat } from 'node:fs/promises';
import { dirname } from 'node:path';
import { UsageError } from './errors.js';

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
