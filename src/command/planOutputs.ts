import { readdir, stat } from 'node:fs/promises';
import { basename, extname, join, resolve } from 'node:path';
import { UsageError } from './readOptions.js';
import { STANDARD, STANDARD_INPUT } from './standardStreams.js';

/** A model, and the paths of its drawings: one, or one for each frame. */
export interface PlannedModel {
  model: string;
  outputs: readonly string[];
}

/**
 * Chooses the paths of drawings.
 *
 * @param out of the command line: a file, a folder, a name with `{name}` and `{frame}`, or `-` for the standard output
 * @param isFolder whether `out` is an existing folder
 * @param frames per model; undefined for one drawing without a number
 * @param written the format of the files
 * @throws UsageError if two drawings would have the same path, a drawing that of a model, or a path that does not end as the format does
 */
export function planOutputs(
  models: readonly string[],
  out: string,
  isFolder: boolean,
  frames: number | undefined,
  written: 'svg' | 'dxf' = 'svg',
): PlannedModel[] {
  if (out === STANDARD) {
    if (models.length === 1 && frames === undefined) return [{ model: models[0], outputs: [STANDARD] }];
    throw new UsageError(
      '--out is -, but the standard output takes one drawing; name a folder, or a file with {name} or {frame}.',
    );
  }
  const hasFrames = frames !== undefined;
  const pattern = patternOf(out, isFolder || /[\\/]$/.test(out), models.length > 1, hasFrames, written);
  const digits = String(frames ?? 1).length;
  const planned = models.map((model) => ({
    model,
    outputs: Array.from({ length: frames ?? 1 }, (_, i) =>
      // Replacements are functions, because names may contain `$` patterns of `replaceAll`.
      pattern
        .replaceAll('{name}', () => nameOf(model, models))
        .replaceAll('{frame}', () => String(i + 1).padStart(digits, '0')),
    ),
  }));
  const owners = new Map<string, string>();
  const inputs = new Set(models.filter((model) => model !== STANDARD).map((model) => resolve(model)));
  for (const { model, outputs } of planned) {
    for (const output of outputs) {
      const other = owners.get(resolve(output));
      if (other !== undefined) {
        const remedy = pattern.includes('{name}')
          ? 'draw them into different folders, or one by one'
          : 'give --out a name with {name}, or draw them one by one';
        throw new UsageError(`${other} and ${model} would both be drawn to ${output}; ${remedy}.`);
      }
      if (inputs.has(resolve(output)))
        throw new UsageError(`--out is ${output}, which is a model; choose another name.`);
      owners.set(resolve(output), model);
    }
  }
  return planned;
}

/** @param isFolder whether `out` is known to be a folder; for several models, a name without an extension is one too */
function patternOf(
  out: string,
  isFolder: boolean,
  areSeveral: boolean,
  hasFrames: boolean,
  written: 'svg' | 'dxf',
): string {
  const isNamed = out.includes('{name}') || (out.includes('{frame}') && hasFrames);
  const ending = isFolder && !isNamed ? '' : extname(out.replaceAll(/\{(name|frame)\}/g, '_'));
  if (ending !== '' && ending.toLowerCase() !== `.${written}`)
    throw new UsageError(
      written === 'dxf'
        ? `--out is ${out}, but DXF is written; name a file that ends in .dxf.`
        : `--out is ${out}, but only SVG and DXF are written; name a file that ends in .svg, which Inkscape and vpype turn into other formats.`,
    );
  if (areSeveral && !isNamed && ending !== '')
    throw new UsageError(
      `--out is ${out}, one file, but there are several models; name a folder, or a file with {name}, as {name}.${written}.`,
    );
  const pattern = (isFolder || areSeveral) && !isNamed ? join(out, `{name}.${written}`) : out;
  if (!hasFrames || pattern.includes('{frame}')) return pattern;
  const extension = extname(pattern);
  return `${pattern.slice(0, pattern.length - extension.length)}-{frame}${extension}`;
}

/** The name of a model in that of its drawing: without its extension, unless another model has the same name then. */
function nameOf(model: string, models: readonly string[]): string {
  const stem = stemOf(model);
  return models.some((other) => other !== model && stemOf(other) === stem) ? basename(model) : stem;
}

/** The name of a model without folder and extension. */
function stemOf(model: string): string {
  if (model === STANDARD) return STANDARD_INPUT;
  const name = basename(model).replace(/\.gz$/i, '');
  return name.slice(0, name.length - extname(name).length) || name;
}

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
