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
  return cut(plain(name), MAX_NAME) || 'a file without a name';
}

/** Text for display that may contain words of a file. */
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

/** A count in words, such as "3 shapes left out"; empty for a count of 0. */
export function counted(count: number, noun: string, rest: string): string {
  return count === 0 ? '' : `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'} ${rest}`;
}
