import { shownText } from '../../viewer/files/common/ModelError.js';
import { element } from '../page/elements.js';

/** Rows above and below those in view that are in the document, so that the focus can move to them. */
const MARGIN = 4;

/** A part in the list. */
export interface PartRow {
  /** Its index in the model. */
  part: number;
  name: string;
  isHidden: boolean;
  /** Whether all others are hidden. */
  isAlone: boolean;
}

interface RowElements {
  item: HTMLLIElement;
  eye: HTMLButtonElement;
  only: HTMLButtonElement;
}

/** An open or a closed eye; which of them shows is up to the style sheet. */
function eyeIcon(): SVGElement {
  const icon = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  icon.setAttribute('viewBox', '0 0 20 14');
  icon.setAttribute('aria-hidden', 'true');
  for (const shape of ['M1 7 Q10 -4 19 7 Q10 18 1 7 Z', 'M10 4.2 a2.8 2.8 0 1 0 .01 0', 'M2 13 L18 1']) {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', shape);
    icon.append(path);
  }
  return icon;
}

/**
 * The rows of a list of parts, each with an eye and a button that leaves it alone. Only rows in view are in the document, and they are
 * reused when the list scrolls. The whole list is one stop of the Tab key; arrow keys move in it.
 */
export class PartRows {
  private rows: readonly PartRow[] = [];
  /** The elements in the document, by the index of their row. */
  private readonly shown = new Map<number, RowElements>();
  private readonly spare: RowElements[] = [];
  /** The row and the button that Tab reaches. */
  private current = 0;
  private column: 'eye' | 'only' = 'eye';
  private height = 0;

  /** @param list inside of an element that scrolls */
  constructor(
    private readonly scroller: HTMLElement,
    private readonly list: HTMLUListElement,
    private readonly on: {
      toggle(part: number): void;
      only(part: number): void;
      /** A part is pointed at, or has the focus of the keyboard; undefined for none. */
      point(part: number | undefined): void;
    },
  ) {
    scroller.addEventListener('scroll', () => this.draw());
    new ResizeObserver(() => this.resized()).observe(scroller);
    list.addEventListener('keydown', (event) => this.press(event));
    list.addEventListener('focusin', ({ target }) => this.focused(target as HTMLElement));
    list.addEventListener('focusout', () => this.on.point(undefined));
    list.addEventListener('pointerover', ({ target, pointerType }) => {
      // A finger points at nothing once it is lifted.
      if (pointerType !== 'touch') this.on.point(this.partAt(target as HTMLElement));
    });
    list.addEventListener('pointerleave', () => this.on.point(undefined));
  }

  show(rows: readonly PartRow[]): void {
    this.rows = rows;
    this.current = Math.max(0, Math.min(this.current, rows.length - 1));
    this.draw();
  }

  /** Scrolls to the first row. */
  restart(): void {
    this.current = 0;
    this.scroller.scrollTop = 0;
  }

  private resized(): void {
    this.height = 0;
    this.draw();
  }

  private draw(): void {
    const { scroller, list, rows, shown } = this;
    this.height ||= Number.parseFloat(getComputedStyle(list).getPropertyValue('--row'));
    const { height } = this;
    list.style.height = `${rows.length * height}px`;
    // The fold is closed.
    if (scroller.clientHeight === 0) return;
    const first = Math.max(0, Math.floor(scroller.scrollTop / height) - MARGIN);
    const last = Math.min(rows.length - 1, Math.ceil((scroller.scrollTop + scroller.clientHeight) / height) + MARGIN);
    for (const [index, elements] of shown) {
      if (index >= first && index <= last) continue;
      // The focus would be lost with its row.
      if (elements.item.contains(document.activeElement) && index < rows.length) continue;
      shown.delete(index);
      elements.item.remove();
      this.spare.push(elements);
    }
    for (let index = first; index <= last; index++) if (!shown.has(index)) this.add(index);
    for (const [index, elements] of shown) this.fill(elements, index);
  }

  private add(index: number): void {
    const elements = this.spare.pop() ?? this.make();
    const next = [...this.shown.keys()].filter((other) => other > index).sort((a, b) => a - b)[0];
    this.shown.set(index, elements);
    // In order, for screen readers.
    this.list.insertBefore(elements.item, next === undefined ? null : this.shown.get(next)!.item);
  }

  private make(): RowElements {
    const eye = element('button', { type: 'button', className: 'part-eye' }, eyeIcon(), element('span'));
    const only = element('button', { type: 'button', className: 'part-only text-button' }, 'Only');
    const item = element('li', { className: 'part' }, eye, only);
    const part = (): number | undefined => this.partAt(item);
    eye.addEventListener('click', () => this.on.toggle(part()!));
    only.addEventListener('click', () => this.on.only(part()!));
    return { item, eye, only };
  }

  private fill({ item, eye, only }: RowElements, index: number): void {
    const { name, isHidden, isAlone } = this.rows[index];
    const text = shownText(name);
    item.dataset.row = String(index);
    item.style.transform = `translateY(${index * this.height}px)`;
    item.setAttribute('aria-setsize', String(this.rows.length));
    item.setAttribute('aria-posinset', String(index + 1));
    eye.lastElementChild!.textContent = text;
    eye.title = `${isHidden ? 'Show' : 'Hide'} ${text}`;
    eye.setAttribute('aria-label', `${text}, shown`);
    eye.setAttribute('aria-pressed', String(!isHidden));
    only.setAttribute('aria-label', `Only ${text}`);
    only.setAttribute('aria-pressed', String(isAlone));
    for (const [name, button] of [['eye', eye] as const, ['only', only] as const])
      button.tabIndex = index === this.current && name === this.column ? 0 : -1;
  }

  private rowAt(target: HTMLElement): number | undefined {
    const { row } = target.closest<HTMLElement>('.part')?.dataset ?? {};
    return row === undefined ? undefined : Number(row);
  }

  private partAt(target: HTMLElement): number | undefined {
    return this.rows[this.rowAt(target) ?? -1]?.part;
  }

  private focused(target: HTMLElement): void {
    this.current = this.rowAt(target) ?? this.current;
    this.column = target.matches('.part-only') ? 'only' : 'eye';
    if (target.matches(':focus-visible')) this.on.point(this.partAt(target));
    this.draw();
  }

  private press(event: KeyboardEvent): void {
    const page = Math.max(1, Math.floor(this.scroller.clientHeight / this.height) - 1);
    const steps: Record<string, number> = {
      ...{ ArrowUp: -1, ArrowDown: 1, PageUp: -page, PageDown: page },
      ...{ Home: -this.rows.length, End: this.rows.length },
    };
    const step = steps[event.key];
    if (step === undefined && event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    // Arrow keys also turn the drawing.
    event.stopPropagation();
    if (step === undefined) this.column = event.key === 'ArrowRight' ? 'only' : 'eye';
    this.current = Math.max(0, Math.min(this.current + (step ?? 0), this.rows.length - 1));
    this.scrollTo(this.current);
    this.draw();
    this.shown.get(this.current)?.[this.column].focus({ preventScroll: true });
  }

  private scrollTo(index: number): void {
    const { scroller, height } = this;
    const top = index * height;
    if (top < scroller.scrollTop) scroller.scrollTop = top;
    else if (top + height > scroller.scrollTop + scroller.clientHeight)
      scroller.scrollTop = top + height - scroller.clientHeight;
  }
}
