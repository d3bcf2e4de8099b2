import { shownName } from './shownText.js';

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
