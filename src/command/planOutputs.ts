import { basename, extname, join, resolve } from 'node:path';
import { UsageError } from './errors.js';
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
 * @throws UsageError if two drawings would have the same path, a drawing that of a model, or a path that does not end in .svg
 */
export function planOutputs(
  models: readonly string[],
  out: string,
  isFolder: boolean,
  frames: number | undefined,
): PlannedModel[] {
  if (out === STANDARD) {
    if (models.length === 1 && frames === undefined) return [{ model: models[0], outputs: [STANDARD] }];
    throw new UsageError(
      '--out is -, but the standard output takes one drawing; name a folder, or a file with {name} or {frame}.',
    );
  }
  const hasFrames = frames !== undefined;
  const pattern = patternOf(out, isFolder || /[\\/]$/.test(out), models.length > 1, hasFrames);
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
function patternOf(out: string, isFolder: boolean, areSeveral: boolean, hasFrames: boolean): string {
  const isNamed = out.includes('{name}') || (out.includes('{frame}') && hasFrames);
  const ending = isFolder && !isNamed ? '' : extname(out.replaceAll(/\{(name|frame)\}/g, '_'));
  if (ending !== '' && ending.toLowerCase() !== '.svg')
    throw new UsageError(
      `--out is ${out}, but only SVG is written; name a file that ends in .svg, which Inkscape and vpype turn into other formats.`,
    );
  if (areSeveral && !isNamed && ending !== '')
    throw new UsageError(
      `--out is ${out}, one file, but there are several models; name a folder, or a file with {name}, as {name}.svg.`,
    );
  const pattern = (isFolder || areSeveral) && !isNamed ? join(out, '{name}.svg') : out;
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
