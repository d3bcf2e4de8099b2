import { element, findElement, textButton } from '../page/elements.js';
import type { Session } from '../session/Session.js';
import { PartHighlight } from './PartHighlight.js';
import { PartRows } from './PartRows.js';

/** Lists with more parts than this can be searched. */
const FEW = 15;

/** The list of the model's parts, which hides and shows them. It is created once, with the first model of several parts. */
export class PartsPanel {
  private readonly fold = findElement('parts') as HTMLDetailsElement;
  private readonly summary = this.fold.querySelector('summary')!;
  private readonly search = element('input', { type: 'search', autocomplete: 'off', placeholder: 'Find a part' });
  private readonly showAll: HTMLButtonElement;
  private readonly onlyFound: HTMLButtonElement;
  private readonly hideFound: HTMLButtonElement;
  private readonly none = element('p', { className: 'parts-none', hidden: true }, 'No part has such a name.');
  private readonly scroller = element('div', { className: 'parts-scroller' });
  private readonly rows: PartRows;
  private readonly highlight: PartHighlight;
  private names: readonly string[] = [];

  constructor(private readonly session: Session) {
    const hide = (isHidden: (part: number) => boolean): void =>
      session.hideParts([...this.names.keys()].filter(isHidden));
    this.showAll = textButton('Show all', () => session.hideParts([]));
    this.onlyFound = textButton('Only these', () => {
      const found = new Set(this.found);
      hide((part) => !found.has(part));
    });
    this.hideFound = textButton('Hide these', () => {
      const found = new Set([...this.found, ...this.hidden]);
      hide((part) => found.has(part));
    });
    this.search.setAttribute('aria-label', 'Find a part');
    this.search.addEventListener('input', () => {
      this.rows.restart();
      this.refresh();
    });
    const list = element('ul', { className: 'parts-list' });
    list.setAttribute('aria-label', 'Parts of the model');
    // Safari takes lists without marks for none.
    list.setAttribute('role', 'list');
    this.highlight = new PartHighlight(session.viewport);
    this.rows = new PartRows(this.scroller, list, {
      toggle: (toggled) => {
        const hidden = new Set(this.hidden);
        if (!hidden.delete(toggled)) hidden.add(toggled);
        hide((part) => hidden.has(part));
      },
      only: (part) => (this.isAlone(part) ? session.hideParts([]) : hide((other) => other !== part)),
      point: (part) => this.highlight.show(part),
    });
    this.scroller.append(list);
    const actions = element('p', { className: 'parts-actions' }, this.showAll, this.onlyFound, this.hideFound);
    this.fold.append(this.search, actions, this.none, this.scroller);
    this.fold.addEventListener('toggle', () => {
      this.refresh();
      if (this.fold.open) this.fold.scrollIntoView({ block: 'nearest' });
    });
    session.listen({ applied: () => this.refresh() });
  }

  /** Shows the parts of another model; none if it has only one. */
  show(): void {
    this.highlight.show(undefined);
    this.search.value = '';
    this.rows.restart();
    this.refresh();
  }

  private get hidden(): readonly number[] {
    return this.session.modelLoader.hidden;
  }

  /** The indices of the parts whose names are searched for. */
  private get found(): number[] {
    const words = this.search.value.trim().toLowerCase().split(/\s+/);
    return [...this.names.keys()].filter((part) => {
      const name = this.names[part].toLowerCase();
      return words.every((word) => name.includes(word));
    });
  }

  private isAlone(part: number): boolean {
    const { hidden, names } = this;
    return hidden.length === names.length - 1 && !hidden.includes(part);
  }

  private refresh(): void {
    const { fold, summary, search, hidden } = this;
    this.names = this.session.viewport.model?.parts?.names ?? [];
    const { names } = this;
    fold.hidden = names.length < 2;
    const count = names.length.toLocaleString('en');
    summary.textContent = `Parts: ${count}${hidden.length > 0 ? `, ${hidden.length.toLocaleString('en')} hidden` : ''}`;
    if (fold.hidden || !fold.open) return;
    const isSearched = search.value.trim() !== '';
    search.hidden = names.length <= FEW;
    this.showAll.disabled = hidden.length === 0;
    this.onlyFound.hidden = this.hideFound.hidden = !isSearched;
    const { found } = this;
    this.onlyFound.disabled = this.hideFound.disabled = found.length === 0;
    this.none.hidden = found.length > 0;
    this.scroller.hidden = found.length === 0;
    const isHidden = new Set(hidden);
    const isOneLeft = hidden.length === names.length - 1;
    this.rows.show(
      found.map((part) => ({
        part,
        name: names[part],
        isHidden: isHidden.has(part),
        isAlone: isOneLeft && !isHidden.has(part),
      })),
    );
  }
}
