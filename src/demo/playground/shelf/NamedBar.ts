import { shownName } from '../../files/common/shownText.js';
import type { NamedItem, NamedList } from './NamedList.js';

/** A row of buttons, one for each of a list. What is shown is pressed. Hidden where there are none. */
export class NamedBar {
  private shown = '';

  constructor(
    private readonly container: HTMLElement,
    private readonly list: NamedList,
  ) {
    this.refresh();
  }

  refresh(): void {
    const { container, list } = this;
    const { items } = list;
    const names = JSON.stringify(items);
    // Otherwise the focus would be lost with each change of a setting.
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
