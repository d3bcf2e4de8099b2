/** As many characters of notes stand in the caption; the others are behind its button. */
const MAX_NOTES = 100;

/** As many notes as fit, the first of them always, and how many more there are. */
export function shortNotes(notes: readonly string[]): string {
  let text = '';
  for (const [i, note] of notes.entries()) {
    const next = text ? `${text}; ${note}` : note;
    if (i > 0 && next.length > MAX_NOTES) return `${text}; ${notes.length - i} more behind “i”`;
    text = next;
  }
  return text;
}
