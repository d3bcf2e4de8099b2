import { shownName } from '../../viewer/files/common/ModelError.js';
import { describeAddress } from '../fetch/fetchModel.js';
import { element } from '../page/elements.js';

/** The first answer is disabled for this long, in milliseconds, so that a click meant for something else agrees to nothing. */
const READING_MILLISECONDS = 600;

interface Question {
  /** The lines of the question. */
  lines: readonly (string | HTMLElement)[];
  yes: string;
  no: string;
  /** Whether agreeing has consequences, so that it must not happen by mistake. */
  isGrave?: boolean;
}

/** Withdraws the open question. */
let withdrawOpen = (): void => {};

/**
 * Asks a question with two answers. Escape gives the second answer, and so does a later question, because only one is open at a time. Each
 * question has its own dialog, so that no answer is taken for another question's.
 *
 * @param signal withdraws the question when aborted, which gives the second answer
 */
async function ask({ lines, yes, no, isGrave = false }: Question, signal?: AbortSignal): Promise<boolean> {
  withdrawOpen();
  if (signal?.aborted) return false;
  const [agree, refuse] = [answer(yes, 'yes'), answer(no, 'no')];
  const question = element('div', { id: 'ask-question' }, ...lines.map((line) => element('p', {}, line)));
  const form = element('form', { method: 'dialog' }, agree, refuse);
  const dialog = element('dialog', { id: 'ask', className: 'ask' }, question, form);
  dialog.setAttribute('aria-labelledby', 'ask-question');
  document.body.append(dialog);
  const end = new AbortController();
  const withdraw = (): void => {
    dialog.close('no');
    dialog.remove();
  };
  withdrawOpen = withdraw;
  signal?.addEventListener('abort', withdraw, { signal: end.signal });
  if (isGrave) {
    refuse.autofocus = true;
    holdBack(agree, end.signal);
  }
  dialog.showModal();
  await new Promise((resolve) => dialog.addEventListener('close', resolve, { once: true }));
  end.abort();
  dialog.remove();
  if (withdrawOpen === withdraw) withdrawOpen = () => {};
  // Escape closes the dialog without a value.
  return dialog.returnValue === 'yes';
}

const answer = (label: string, value: string): HTMLButtonElement =>
  element('button', { type: 'submit', value, className: 'text-button' }, label);

/** Disables a button for a moment, and again when the window returns to the front. */
function holdBack(button: HTMLButtonElement, end: AbortSignal): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const hold = (): void => {
    button.disabled = true;
    clearTimeout(timer);
    timer = setTimeout(() => {
      button.disabled = false;
    }, READING_MILLISECONDS);
  };
  hold();
  addEventListener('focus', hold, { signal: end });
  end.addEventListener('abort', () => clearTimeout(timer));
}

/** Asks whether dropped pictures are a tonal art map, which cannot be told from the pictures. */
export function askForStrokes(names: readonly string[]): Promise<boolean> {
  const question =
    names.length === 1
      ? `${shownName(names[0])} belongs to no model here. Draw with it as strokes?`
      : `These ${names.length} pictures belong to no model here. Draw with them as strokes, one tone each?`;
  return ask({ lines: [question], yes: 'Draw strokes', no: 'Leave the drawing' });
}

/** Asks whether a model may be fetched from another site, which will learn of the visit. */
export function askToFetch(address: string, signal: AbortSignal): Promise<boolean> {
  const { name, site } = describeAddress(address);
  const lines = [
    'This link asks for a model from another site:',
    part('ask-site', site),
    part('ask-file', `File: ${shownName(name)}`),
    'Fetch it? The site will see that you do.',
  ];
  return ask({ lines, yes: 'Fetch it', no: 'Leave it', isGrave: true }, signal);
}

/** Text from an untrusted source, which must not look like part of the question. */
const part = (className: string, textContent: string): HTMLElement =>
  element('bdi', { className, textContent, dir: 'ltr' });
