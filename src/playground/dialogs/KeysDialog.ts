import { findElement } from '../page/elements.js';

/** Keys and gestures, grouped by where they work. All keys of a row do what `text` says. */
const KEYS: readonly { about: string; rows: readonly (readonly [keys: string, text: string])[] }[] = [
  {
    about: 'Mouse and fingers',
    rows: [
      ['Drag', 'turns the model; the lamp moves the light, past the edge of the model and back behind it'],
      ['Wheel, pinch', 'nearer, farther'],
      ['Right button, two fingers', 'move the model'],
      ['Double-click', 'shows the model whole; on the name of a setting, resets it'],
      ['Shift, second finger', 'while a lamp or spot is dragged, changes its distance'],
    ],
  },
  {
    about: 'The drawing, once it is clicked or reached with Tab',
    rows: [
      ['← → ↑ ↓', 'turn it, with Shift finely'],
      ['+ −', 'nearer, farther'],
      ['W A S D', 'move it'],
      ['Home', 'show it whole'],
      ['Space', 'play or pause a model that moves'],
    ],
  },
  {
    about: 'The light, reached with Tab',
    rows: [
      ['← → ↑ ↓', 'move it, with Shift finely'],
      ['Page Up, Page Down', 'farther, nearer, if it is a lamp or a spot'],
      ['Home', 'where it was at first'],
    ],
  },
  {
    about: 'Everywhere but in a field',
    rows: [
      ['Ctrl Z', 'undo'],
      ['Ctrl Y, Ctrl Shift Z', 'redo'],
      ['1 to 9', 'go to a view that was kept'],
      ['F', 'full screen'],
      ['Esc', 'close what is open'],
      ['?, H, F1', 'these keys'],
    ],
  },
];

/** The list of keys and gestures. */
export class KeysDialog {
  private readonly dialog = findElement('keys') as HTMLDialogElement;

  constructor() {
    findElement('keys-close').addEventListener('click', () => this.dialog.close());
    findElement('keys-list').append(...KEYS.flatMap(({ about, rows }) => [element('h3', about), list(rows)]));
  }

  open(): void {
    if (!this.dialog.open) this.dialog.showModal();
  }
}

function list(rows: readonly (readonly [string, string])[]): HTMLElement {
  const terms = document.createElement('dl');
  terms.append(...rows.flatMap(([keys, text]) => [element('dt', keys), element('dd', text)]));
  return terms;
}

const element = (tag: string, textContent: string): HTMLElement =>
  Object.assign(document.createElement(tag), { textContent });
