import { SHEET_WORDS, type Sheet, sheetNamed } from '../vector/svg/sheetSizes.js';
import { UsageError } from './UsageError.js';
import { shown } from './values.js';

/**
 * The sheet after `--sheet`.
 *
 * @throws UsageError if there is none of that name
 */
export function sheetOf(text: string): Sheet {
  const sheet = sheetNamed(text);
  if (sheet) return sheet;
  throw new UsageError(`--sheet is ${shown(text)}, but must be ${SHEET_WORDS}.`);
}
