import { type ParseArgsConfig, parseArgs } from 'node:util';

/** A mistake in the command line, reported without a stack trace. */
export class UsageError extends Error {}

/** The user interrupted the command. The message says how many files were written. */
export class Interrupted extends Error {
  /** @param written number of files written before the interruption */
  constructor(written = 0) {
    const files = written === 1 ? '1 file was' : `${written} files were`;
    super(`interrupted; ${written === 0 ? 'nothing was written' : `${files} written before that`}.`);
  }
}

/** The options of a command, as Node's parser takes them. */
type Options = NonNullable<ParseArgsConfig['options']>;

/** The maximum number of changed letters for a suggestion. */
const MISTYPED = 2;

/**
 * Reads the options of a command. The last of repeated options counts, unless they are `multiple`.
 *
 * @param help the command line that prints the help
 * @throws UsageError whose message is a single sentence, with a suggestion for a mistyped option
 */
export function readOptions<Known extends Options>(args: readonly string[], options: Known, help: string) {
  const joined = withValues(args, options);
  try {
    return parseArgs({ args: joined, options, allowPositionals: true });
  } catch (error) {
    throw new UsageError(whyRefused(joined, options, help) ?? (error as Error).message);
  }
}

/** Joins options to values that begin with a dash, such as angles and axes, which Node would take for options. */
function withValues(args: readonly string[], options: Options): string[] {
  const joined: string[] = [];
  for (const [i, arg] of args.entries()) {
    if (arg === '--') return [...joined, ...args.slice(i)];
    const before = joined.at(-1);
    const takesValue = before?.startsWith('--') && options[before.slice(2)]?.type === 'string';
    if (takesValue && /^-(\d|\.|[xyz]$)/i.test(arg)) joined.push(`${joined.pop()}=${arg}`);
    else joined.push(arg);
  }
  return joined;
}

/** Describes the first invalid option in a sentence. */
function whyRefused(args: readonly string[], options: Options, help: string): string | undefined {
  const { tokens } = parseArgs({ args: [...args], options, strict: false, allowPositionals: true, tokens: true });
  for (const token of tokens) {
    if (token.kind !== 'option') continue;
    const { name, rawName, value } = token;
    const known = Object.hasOwn(options, name) ? options[name] : undefined;
    if (!known && !rawName.startsWith('--'))
      return `${args[token.index]} is not an option; write ./ before the name of a file that begins with a dash. See ${help}.`;
    if (!known) {
      const meant = nearest(name, Object.keys(options));
      return `${rawName} is not an option${meant === undefined ? '' : `; --${meant} may be meant`}. See ${help}.`;
    }
    if (known.type === 'boolean' && value !== undefined) return `${rawName} takes no value. See ${help}.`;
    if (known.type === 'string' && (value === undefined || (!token.inlineValue && /^-./.test(value))))
      return `${rawName} needs a value after it. See ${help}.`;
  }
  return undefined;
}

/** The name with the fewest letters changed, regardless of case; undefined if none is near. */
function nearest(typed: string, names: readonly string[]): string | undefined {
  const distances = names.map((name) => ({ name, distance: changesBetween(typed.toLowerCase(), name) }));
  const [best] = distances.sort((a, b) => a.distance - b.distance);
  const most = Math.min(MISTYPED, Math.ceil(typed.length / 2) - 1);
  return best && best.distance <= Math.max(most, 0) ? best.name : names.find((name) => isBeginning(typed, name));
}

const isBeginning = (typed: string, name: string): boolean =>
  Math.min(typed.length, name.length) > 2 && (name.startsWith(typed) || typed.startsWith(name));

/** The edit distance between two words: letters added, left out, replaced or swapped. */
export function changesBetween(a: string, b: string): number {
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)];
  for (let i = 1; i <= a.length; i++) {
    rows[i] = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = rows[i - 1][j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      const isSwapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      const swapped = isSwapped ? rows[i - 2][j - 2] + 1 : Infinity;
      rows[i][j] = Math.min(rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced, swapped);
    }
  }
  return rows[a.length][b.length];
}

/** A value for a message, in quotes if it is empty or contains white space. */
export const shown = (value = ''): string => (/^\S+$/.test(value) ? value : `"${value}"`);
