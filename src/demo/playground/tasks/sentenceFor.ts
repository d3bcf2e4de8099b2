import { errorMessage } from '../../files/common/errorMessage.js';
import { ModelError } from '../../files/common/ModelError.js';

/** What Chromium, Firefox and Safari say where a script that is loaded on demand is missing. */
const MISSING_SCRIPT = /dynamically imported module|importing a module script/i;

/** What the status line says of an error. */
export function sentenceFor(error: unknown): string {
  if (error instanceof ModelError) return error.message;
  const message = errorMessage(error);
  if (MISSING_SCRIPT.test(message)) {
    return 'A part of this page could not be fetched. Look after the connection, and reload the page.';
  }
  return `That did not work: ${message}`;
}
