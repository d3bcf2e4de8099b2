import { shownName } from '../../viewer/files/common/shownText.js';
import type { NamedItem, NamedList } from './NamedList.js';

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
    const button = Object.assign(document.createElement('button'), { type: 'button', title: name });
    if (picture) button.append(Object.assign(document.createElement('img'), { alt: '', src: picture }));
    button.append(Object.assign(document.createElement('span'), { textContent: name }));
    if (key) {
      button.prepend(Object.assign(document.createElement('kbd'), { textContent: key }));
      button.setAttribute('aria-keyshortcuts', key);
    }
    button.addEventListener('click', () => this.list.choose(index));
    return button;
  }
}
