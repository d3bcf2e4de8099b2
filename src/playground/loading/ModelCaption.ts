import type { ModelStatistics } from '../../viewer/drawing/HatchedModel.js';
import { shownName, shownText } from '../../viewer/files/common/shownText.js';

/** The most characters of notes in the caption. Its button shows the rest. */
const MAX_NOTES = 100;

/** Joins as many notes as fit, always the first, and says how many more there are. */
export function shortNotes(notes: readonly string[]): string {
  let text = '';
  for (const [i, note] of notes.entries()) {
    const next = text ? `${text}; ${note}` : note;
    if (i > 0 && next.length > MAX_NOTES) return `${text}; ${notes.length - i} more behind “i”`;
    text = next;
  }
  return text;
}

/** What the page says about a model. */
export interface CaptionContent {
  title: string;
  statistics: ModelStatistics;
  /** Notes that the user should see at once, the most important first. */
  notes: readonly string[];
  /** Notes for users who look closer. */
  details: readonly string[];
}

/** The caption of a model: its name and its most important notes, with a button that shows all notes and the statistics. */
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
    // It closes as a menu does, when the user presses anything else.
    addEventListener('pointerdown', ({ target }) => {
      if (!about.contains(target as Node)) about.open = false;
    });
  }

  /** @param content undefined if no model is shown */
  show(content: CaptionContent | undefined): void {
    this.content = content;
    const { caption, about, notes, statistics } = this.elements;
    about.hidden = !content;
    if (!content) {
      caption.replaceChildren();
      return;
    }
    const all = [...content.notes, ...content.details];
    // The elements are replaced, because new text in the old ones would count as a layout shift.
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

/** Puts the statistics into words. Counts of zero are left out. */
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
