/** The most characters that are shown of a file's name, and of a sentence. */
const MAX_NAME = 60;
const MAX_TEXT = 400;

/** Characters that change the direction of text, join it, or are invisible; half of a surrogate pair; the blank of Braille. */
const UNSEEN = /[\p{Cf}\p{Cs}\p{Default_Ignorable_Code_Point}\u2800]/gu;
const BLANKS = /[\s\p{Cc}]+/gu;
/** More accents than any script sets on a letter: they would be drawn over the lines above. */
const PILED_MARKS = /(\p{M}{3})\p{M}+/gu;

/**
 * The name of a file as it is shown: in one line, in the order in which it is written, and with its middle left out where it is long,
 * so that neither its beginning nor its extension can be pushed out of sight. Files are found by their names as they are.
 */
export function shownName(name: string): string {
  return cut(plain(name), MAX_NAME) || 'a file without a name';
}

/** Text that may contain words of a file, as it is shown. */
export function shownText(text: string): string {
  return cut(plain(text), MAX_TEXT);
}

const plain = (text: string): string => text.replace(UNSEEN, '').replace(PILED_MARKS, '$1').replace(BLANKS, ' ').trim();

function cut(text: string, most: number): string {
  const characters = [...text];
  if (characters.length <= most) return text;
  const half = (most - 1) / 2;
  return `${characters.slice(0, Math.ceil(half)).join('')}…${characters.slice(-Math.floor(half)).join('')}`;
}
