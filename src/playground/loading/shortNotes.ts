/** The most characters of notes in the caption. Its button shows the rest. */
const MAX_NOTES = 100;

/** Joins as many notes as fit, always the first, and says how many more there are. */
export function shortNotes(notes: readonly string[]): string {
  let text = '';
  for (const [i, note] of notes.entries()) {
    const next = text ? `${text}; ${note}` : note;
    if (i > 0 && next.length > MAX_NOTES) return `${text}; ${notes.length - i} more behind “i”`;
    text = next;
  }
  return text;
}
