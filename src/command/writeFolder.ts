import { randomBytes } from 'node:crypto';
import { existsSync } from 'node:fs';
import { mkdir, readdir, rename, rm, writeFile } from 'node:fs/promises';
import { basename, dirname, join, resolve } from 'node:path';
import type { MapFile } from '../mapFiles/mapFiles.js';
import { UsageError } from './parseArguments.js';

/** Whether a file name is one of a saved map. */
const isMapFile = (name: string): boolean => /^(map\.json|(tone-\d+|thresholds)-level-\d+\.png)$/.test(name);

/**
 * Checks that a map may be written into a folder.
 *
 * @throws UsageError if the folder holds other files, or a map while `force` is false
 */
export async function assertWritable(folder: string, force: boolean): Promise<void> {
  if (!existsSync(folder)) return;
  let names: string[];
  try {
    names = await readdir(folder);
  } catch {
    throw new UsageError(`${folder} is not a folder; choose another name after --out.`);
  }
  const other = names.find((name) => !isMapFile(name));
  if (other !== undefined) {
    throw new UsageError(`${folder} holds other files (${other}); choose a folder of its own after --out.`);
  }
  if (names.length > 0 && !force) {
    throw new UsageError(`${folder} holds a map already; add --force to replace it, or choose another folder.`);
  }
}

/** Writes all files of a map or none: into a temporary folder, which is then renamed to `folder`. */
export async function writeFolder(folder: string, files: readonly MapFile[], signal: AbortSignal): Promise<void> {
  const target = resolve(folder);
  const unique = randomBytes(4).toString('hex');
  const temporary = (what: string): string => join(dirname(target), `.${basename(target)}-${what}-${unique}`);
  const [fresh, old] = [temporary('new'), temporary('old')];
  try {
    await mkdir(fresh, { recursive: true });
    for (const { name, bytes } of files) {
      signal.throwIfAborted();
      await writeFile(join(fresh, name), bytes);
    }
    signal.throwIfAborted();
    if (existsSync(target)) await rename(target, old);
    try {
      await rename(fresh, target);
    } catch (error) {
      if (existsSync(old)) await rename(old, target);
      throw error;
    }
  } finally {
    await rm(fresh, { recursive: true, force: true });
    await rm(old, { recursive: true, force: true });
  }
}
