import { readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';

/** The maximum number of folders that `**` searches. */
const MANY_FOLDERS = 10_000;

/** Whether a name contains characters of a pattern. */
export const isPattern = (name: string): boolean => /[*?[{]/.test(name);

/**
 * The files that match a pattern, sorted by name: `*` and `?` stand for characters of a name, `[abc]` for one of them, `{a,b}` for one of
 * the words, and `**` for any folders. Names that begin with a dot match only a pattern that does too. Needed because Windows shells do not
 * expand patterns.
 */
export async function expandPattern(pattern: string): Promise<string[]> {
  const found = await Promise.all(alternatives(pattern.replaceAll('\\', '/')).map(filesOf));
  return [...new Set(found.flat())].sort();
}

/** The patterns that result from each choice of the words in braces. */
function alternatives(pattern: string): string[] {
  const match = /^(.*?)\{([^{}]*)\}(.*)$/.exec(pattern);
  if (!match) return [pattern];
  const [, before, words, after] = match;
  return words.split(',').flatMap((word) => alternatives(`${before}${word}${after}`));
}

async function filesOf(pattern: string): Promise<string[]> {
  const steps = pattern.split('/').filter((step, i) => step !== '' || i === 0);
  const isAbsolute = steps[0] === '';
  let paths = [isAbsolute ? '/' : ''];
  for (const step of isAbsolute ? steps.slice(1) : steps) {
    paths =
      step === '**'
        ? await foldersBelow(paths)
        : isPattern(step)
          ? (await Promise.all(paths.map((path) => matching(path, step)))).flat()
          : paths.map((path) => join(path, step));
  }
  const files = await Promise.all(paths.map(async (path) => ((await isFile(path)) ? [path] : [])));
  return files.flat();
}

async function matching(folder: string, step: string): Promise<string[]> {
  const expression = new RegExp(
    `^${[...step.matchAll(/\[[^\]]+\]|[\s\S]/g)].map(([part]) => sourceOf(part)).join('')}$`,
  );
  const names = await readdir(folder || '.').catch(() => []);
  return names
    .filter((name) => expression.test(name) && (!name.startsWith('.') || step.startsWith('.')))
    .map((name) => join(folder, name));
}

/** Translates a part of a pattern to the source of a regular expression. */
function sourceOf(part: string): string {
  if (part === '*') return '.*';
  if (part === '?') return '.';
  if (part.length > 1)
    return `[${part
      .slice(1, -1)
      .replace(/^!/, '^')
      .replace(/[\\\]]/g, '\\$&')}]`;
  return part.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&');
}

/** Folders and all folders below them. Symbolic links are not followed, since they may form a loop. */
async function foldersBelow(folders: readonly string[]): Promise<string[]> {
  const all = [...folders];
  for (let i = 0; i < all.length && all.length < MANY_FOLDERS; i++) {
    const entries = await readdir(all[i] || '.', { withFileTypes: true }).catch(() => []);
    for (const entry of entries)
      if (entry.isDirectory() && !entry.name.startsWith('.')) all.push(join(all[i], entry.name));
  }
  return all;
}

async function isFile(path: string): Promise<boolean> {
  return (await stat(path).catch(() => undefined))?.isFile() ?? false;
}
