import { describeAddress } from './fetchModel.js';
import { page } from './page.js';

/** Asks a question with two answers. Escape is the second one. */
function ask(question: string, yes: string, no: string): Promise<boolean> {
  const { dialog } = page.ask;
  page.ask.question.textContent = question;
  page.ask.yes.textContent = yes;
  page.ask.no.textContent = no;
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), { once: true });
    // Escape closes it without a value.
    dialog.returnValue = '';
    dialog.showModal();
  });
}

/** Asks whether pictures are to be drawn with, because nobody can tell that from a picture. */
export function askForStrokes(names: readonly string[]): Promise<boolean> {
  const [first] = names;
  const question =
    names.length === 1
      ? `${first} belongs to no model here. Draw with it as strokes?`
      : `These ${names.length} pictures belong to no model here. Draw with them as strokes, one tone each?`;
  return ask(question, 'Draw strokes', 'Leave the drawing');
}

/** Asks whether a model may be fetched from another site, which then knows of the visit. */
export function askToFetch(address: string): Promise<boolean> {
  const { name, site } = describeAddress(address);
  const question = `This link asks for a model from another site: ${name}, from ${site}. Fetch it? The site will see that you do.`;
  return ask(question, 'Fetch it', 'Leave it');
}
