import { page } from './page.js';

/** Asks whether pictures are to be drawn with, because nobody can tell that from a picture. */
export function askForStrokes(names: readonly string[]): Promise<boolean> {
  const { dialog, question } = page.ask;
  const [first] = names;
  question.textContent =
    names.length === 1
      ? `${first} belongs to no model here. Draw with it as strokes?`
      : `These ${names.length} pictures belong to no model here. Draw with them as strokes, one tone each?`;
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), { once: true });
    // Escape closes it without a value.
    dialog.returnValue = '';
    dialog.showModal();
  });
}
