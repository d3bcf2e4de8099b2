import { basename, extname, join, resolve } from 'node:path';
import { UsageError } from './UsageError.js';

/** A model, and the files of its drawings: one, or one for each frame. */
export interface PlannedModel {
  model: string;
  outputs: readonly string[];
}

/**
 * Names the files of drawings.
 *
 * @param out what the command line says: a file, a folder, or a name with `{name}` and `{frame}`
 * @param isFolder whether `out` is a folder that is there
 * @param frames of each model; undefined for one drawing without a number
 * @throws UsageError if two drawings would have the same name, or a drawing that of a model
 */
export function planOutputs(
  models: readonly string[],
  out: string,
  isFolder: boolean,
  frames: number | undefined,
): PlannedModel[] {
  const pattern = patternOf(out, isFolder || /[\\/]$/.test(out) || models.length > 1, frames !== undefined);
  const digits = String(frames ?? 1).length;
  const planned = models.map((model) => ({
    model,
    outputs: Array.from({ length: frames ?? 1 }, (_, i) =>
      // By functions, because names may hold what `replaceAll` takes for a group.
      pattern
        .replaceAll('{name}', () => nameOf(model, models))
        .replaceAll('{frame}', () => String(i + 1).padStart(digits, '0')),
    ),
  }));
  const owners = new Map<string, string>();
  const inputs = new Set(models.map((model) => resolve(model)));
  for (const { model, outputs } of planned) {
    for (const output of outputs) {
      const other = owners.get(resolve(output));
      if (other !== undefined)
        throw new UsageError(
          `${other} and ${model} would both be drawn to ${output}; give --out a name with {name}, or draw them one by one.`,
        );
      if (inputs.has(resolve(output)))
        throw new UsageError(`--out is ${output}, which is a model; choose another name.`);
      owners.set(resolve(output), model);
    }
  }
  return planned;
}

function patternOf(out: string, isFolder: boolean, hasFrames: boolean): string {
  const isNamed = out.includes('{name}') || (out.includes('{frame}') && hasFrames);
  const pattern = isFolder && !isNamed ? join(out, '{name}.svg') : out;
  if (!hasFrames || pattern.includes('{frame}')) return pattern;
  const extension = extname(pattern);
  return `${pattern.slice(0, pattern.length - extension.length)}-{frame}${extension}`;
}

/** The name of a model in that of its drawing: without its extension, if no other model is named the same then. */
function nameOf(model: string, models: readonly string[]): string {
  const stem = stemOf(model);
  return models.some((other) => other !== model && stemOf(other) === stem) ? basename(model) : stem;
}

/** The name of a model without its folder and its extension. */
function stemOf(model: string): string {
  const name = basename(model).replace(/\.gz$/i, '');
  return name.slice(0, name.length - extname(name).length) || name;
}
