import { shownName } from '../../viewer/files/common/ModelError.js';
import { element, findElement, textButton } from '../page/elements.js';
import type { NamedItem, NamedList } from './SavedViews.js';

/** The part of a list that a bar shows. */
export type BarItems = Pick<NamedList, 'items' | 'choose' | 'isShown'>;

/** A row of buttons, one for each item of a list. The button of the shown item is pressed. An empty row is hidden. */
export class NamedBar {
  private shown = '';

  constructor(
    private readonly container: HTMLElement,
    private readonly list: BarItems,
  ) {
    this.refresh();
  }

  refresh(): void {
    const { container, list } = this;
    const { items } = list;
    const names = JSON.stringify(items);
    // Replacing the buttons at each change of a setting would take the focus from them.
    if (names !== this.shown) container.replaceChildren(...items.map((item, i) => this.button(item, i)));
    this.shown = names;
    container.hidden = items.length === 0;
    [...container.children].forEach((button, i) => {
      button.setAttribute('aria-pressed', String(list.isShown(i)));
    });
  }

  private button({ name: given, picture, key }: NamedItem, index: number): HTMLElement {
    const name = shownName(given);
    const button = element('button', { type: 'button', title: name });
    if (picture) button.append(element('img', { alt: '', src: picture }));
    button.append(element('span', {}, name));
    if (key) {
      button.prepend(element('kbd', {}, key));
      button.setAttribute('aria-keyshortcuts', key);
    }
    button.addEventListener('click', () => this.list.choose(index));
    return button;
  }
}

/** The texts of a list's dialog. */
export interface ListWords {
  title: string;
  about: string;
  /** The label of the button that adds the present look or view. */
  add: string;
  full: string;
}

/** Lists named items, which can be added, chosen, renamed and deleted. */
export class NamedListDialog {
  private readonly dialog = findElement('named') as HTMLDialogElement;
  private readonly name = findElement('named-name') as HTMLInputElement;
  private readonly addButton = findElement('named-add') as HTMLButtonElement;
  private readonly rows = findElement('named-list');
  private readonly said = findElement('named-said');
  private list: NamedList | undefined;
  private words: ListWords | undefined;

  constructor() {
    findElement('named-close').addEventListener('click', () => this.dialog.close());
    findElement('named-form').addEventListener('submit', (event) => {
      event.preventDefault();
      if (this.list) this.show(this.list.add(this.name.value));
      this.rows.lastElementChild?.scrollIntoView({ block: 'nearest' });
    });
  }

  open(list: NamedList, words: ListWords): void {
    this.list = list;
    this.words = words;
    findElement('named-title').textContent = words.title;
    findElement('named-about').textContent = words.about;
    this.addButton.textContent = words.add;
    this.show(undefined);
    this.dialog.showModal();
  }

  /** Shows the list. @param sentence a sentence about the last change */
  private show(sentence: string | undefined): void {
    const { list, words, name, addButton } = this;
    if (!list || !words) return;
    this.rows.replaceChildren(...list.items.map((item, i) => this.row(list, item, i)));
    name.value = list.freeName;
    for (const field of [name, addButton]) field.disabled = list.isFull;
    this.said.textContent = sentence ?? (list.isFull ? words.full : '');
  }

  private row(list: NamedList, { name: given, picture, key }: NamedItem, index: number): HTMLElement {
    const name = shownName(given);
    const row = element('li');
    if (key) row.append(element('kbd', {}, key));
    if (picture) row.append(element('img', { alt: '', src: picture }));
    const field = element('input', { type: 'text', value: name, maxLength: 40 });
    field.setAttribute('aria-label', `Name of ${name}`);
    field.addEventListener('change', () => this.show(list.rename(index, field.value)));
    const choose = (): void => {
      this.dialog.close();
      list.choose(index);
    };
    const remove = (): void => {
      this.show(list.remove(index));
      this.name.focus();
    };
    const buttons = [textButton('Show', choose, `Show ${name}`), textButton('Delete', remove, `Delete ${name}`)];
    row.append(field, ...buttons);
    return row;
  }
}
