import { errorMessage } from '../../viewer/files/common/errorMessage.js';
import { ModelError } from '../../viewer/files/common/ModelError.js';

/** The messages of Chromium, Firefox and Safari for a dynamic import that has failed. */
const MISSING_SCRIPT = /dynamically imported module|importing a module script/i;

/** The sentence about an error for the status line. */
export function sentenceFor(error: unknown): string {
  if (error instanceof ModelError) return error.message;
  const message = errorMessage(error);
  if (MISSING_SCRIPT.test(message)) {
    return 'A part of this page could not be fetched. Check the connection and reload the page.';
  }
  return `That did not work: ${message}`;
}
