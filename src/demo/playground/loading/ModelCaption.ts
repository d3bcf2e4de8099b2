import type { ModelStatistics } from '../../drawing/HatchedModel.js';
import { shownName, shownText } from '../../files/common/shownText.js';
import { shortNotes } from './shortNotes.js';

/** What there is to say of a model. */
export interface CaptionContent {
  title: string;
  statistics: ModelStatistics;
  /** What its user should know at first sight; what matters most comes first. */
  notes: readonly string[];
  /** What only those want to know who look closer. */
  details: readonly string[];
}

/** The caption of a model: its name and what matters about it; its statistics and all the rest behind a button. */
export class ModelCaption {
  content: CaptionContent | undefined;

  constructor(
    private readonly elements: {
      caption: HTMLElement;
      about: HTMLDetailsElement;
      notes: HTMLElement;
      statistics: HTMLElement;
    },
  ) {
    const { about } = elements;
    about.addEventListener('keydown', ({ key }) => {
      if (key !== 'Escape' || !about.open) return;
      about.open = false;
      about.querySelector('summary')!.focus();
    });
    // As a menu does, it goes when the drawing or anything else is turned to.
    addEventListener('pointerdown', ({ target }) => {
      if (!about.contains(target as Node)) about.open = false;
    });
  }

  /** @param content undefined where nothing is shown */
  show(content: CaptionContent | undefined): void {
    this.content = content;
    const { caption, about, notes, statistics } = this.elements;
    about.hidden = !content;
    if (!content) {
      caption.replaceChildren();
      return;
    }
    const all = [...content.notes, ...content.details];
    // New elements: new text in the old ones would count as a layout shift.
    caption.replaceChildren(
      element('em', 'model-name', shownName(content.title)),
      ' ',
      element('span', 'model-note', shortNotes(content.notes.map(shownText))),
    );
    notes.replaceChildren(...all.map((note) => element('li', '', shownText(note))));
    notes.hidden = all.length === 0;
    statistics.textContent = describe(content.statistics);
  }
}

function element(tag: string, id: string, textContent: string): HTMLElement {
  return Object.assign(document.createElement(tag), { ...(id && { id }), textContent });
}

/** The statistics in words. Counts of zero are left out. */
function describe({ triangles, borderEdges, nonManifoldEdges, degenerateTriangles }: ModelStatistics): string {
  return [
    count(triangles, 'triangle'),
    count(borderEdges, 'border edge'),
    count(nonManifoldEdges, 'non-manifold edge'),
    degenerateTriangles > 0 ? `${degenerateTriangles.toLocaleString('en')} without area` : '',
  ]
    .filter(Boolean)
    .join(', ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
