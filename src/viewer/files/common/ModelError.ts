/** The model cannot be drawn. The message is one sentence for the user. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
}

/**
 * Converts an error thrown while a file was read to a sentence for the user. A ModelError is returned as it is. A loader's message is
 * included; one of the JavaScript engine (`Cannot read properties of undefined`) is not, since it means nothing to users.
 *
 * @param file the name of the dropped file
 * @param part the part that was being read, as the subject of a sentence
 */
export function toModelError(file: string, error: unknown, part = 'it'): ModelError {
  if (error instanceof ModelError) return error;
  const message = errorMessage(error);
  const name = shownName(file);
  if (/^The hatching worker /.test(message)) {
    return new ModelError(
      `${name} was not prepared to the end: the browser has ended the worker that did it, most often for want of memory. Open it again, or a smaller one.`,
    );
  }
  if (/allocation failed|out of memory|invalid (array|string) length/i.test(message)) {
    return new ModelError(`${name} needs more memory than this page can get, or ${part} is damaged.`);
  }
  const reason = isOfLoader(error) ? plain(message) : '';
  return new ModelError(`${name} could not be read; ${part} seems to be damaged${reason && ` (${reason})`}.`);
}

/** Whether a loader threw the error: errors of the JavaScript engine and of the browser have other names than `Error`. */
function isOfLoader(error: unknown): error is Error {
  return error instanceof Error && error.name === 'Error' && Object.getPrototypeOf(error) === Error.prototype;
}

/** A loader's message without the prefix that names the loader. */
const plain = (message: string): string =>
  message
    .replace(/^(THREE\.)?\w+(\.\w+)*(\(\))?:\s*/, '')
    .replace(/[.\s]+$/, '')
    .slice(0, 200);

/** The message of an error, or of anything else that was thrown. */
export function errorMessage(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** The maximum numbers of characters shown of a file name and of a sentence. */
const MAX_NAME = 60;
const MAX_TEXT = 400;

/** Invisible characters: format controls, joiners, bidirectional controls, lone surrogates, and the Braille blank. */
const UNSEEN = /[\p{Cf}\p{Cs}\p{Default_Ignorable_Code_Point}\u2800]/gu;
const BLANKS = /[\s\p{Cc}]+/gu;
/** More combining marks than any script puts on a letter; they would be drawn over the lines above. */
const PILED_MARKS = /(\p{M}{3})\p{M}+/gu;

/**
 * A file name for display: in one line, without characters that reorder text, and shortened in the middle, so that neither its beginning
 * nor its extension is hidden. Files are looked up by their original names.
 */
export function shownName(name: string): string {
  return cut(printable(name), MAX_NAME) || 'a file without a name';
}

/** Text for display that may contain words of a file. */
export function shownText(text: string): string {
  return cut(printable(text), MAX_TEXT);
}

const printable = (text: string): string =>
  text.replace(UNSEEN, '').replace(PILED_MARKS, '$1').replace(BLANKS, ' ').trim();

function cut(text: string, most: number): string {
  const characters = [...text];
  if (characters.length <= most) return text;
  const half = (most - 1) / 2;
  return `${characters.slice(0, Math.ceil(half)).join('')}…${characters.slice(-Math.floor(half)).join('')}`;
}

/** A count in words, such as "3 shapes left out"; empty for a count of 0. */
export function counted(count: number, noun: string, rest: string): string {
  return count === 0 ? '' : `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'} ${rest}`;
}

/**
 * Makes names distinct: missing names become a number, such as `Clip 2`, and repeated names get one too.
 *
 * @param kind the word for things without a name
 */
export function distinctNames(names: readonly (string | undefined)[], kind: string): string[] {
  const taken = new Map<string, number>();
  return names.map((given, i) => {
    const name = given || `${kind} ${i + 1}`;
    const before = taken.get(name) ?? 0;
    taken.set(name, before + 1);
    return before === 0 ? name : `${name} ${before + 1}`;
  });
}

/** The index of a name in a list: by exact match, or else regardless of case, or else as a number counted from 1; −1 if there is none. */
export function indexOfName(names: readonly string[], wanted: string): number {
  const plain = wanted.trim().toLowerCase();
  for (const named of [names.indexOf(wanted), names.findIndex((name) => name.trim().toLowerCase() === plain)])
    if (named !== -1) return named;
  const number = Number(wanted);
  return Number.isInteger(number) && number >= 1 && number <= names.length ? number - 1 : -1;
}
