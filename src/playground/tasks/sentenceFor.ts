import { errorMessage, ModelError } from '../../viewer/files/common/ModelError.js';

/** The messages of Chromium, Firefox and Safari for a failed dynamic import. */
const MISSING_SCRIPT = /dynamically imported module|importing a module script/i;

/** Describes an error for the status line. */
export function sentenceFor(error: unknown): string {
  if (error instanceof ModelError) return error.message;
  const message = errorMessage(error);
  if (MISSING_SCRIPT.test(message)) {
    return 'A part of this page could not be fetched. Check the connection and reload the page.';
  }
  return `That did not work: ${message}`;
}
