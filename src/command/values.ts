/** A number in decimal notation; not a number for anything else, also where JavaScript reads one, as of `0x10` or of blanks. */
export const numberOf = (text: string): number =>
  /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i.test(text) ? Number(text) : Number.NaN;

/** A value of the command line in a sentence: in quotes where it would not be seen to begin and to end. */
export const shown = (value = ''): string => (/^\S+$/.test(value) ? value : `"${value}"`);
