import type { ModelStatistics } from '../../viewer/drawing/statistics.js';
import { shownName, shownText } from '../../viewer/files/common/ModelError.js';
import { element } from '../page/elements.js';

/** The maximum length of notes in the caption. Its button shows the rest. */
const MAX_NOTES = 100;

/** Joins as many notes as fit, at least the first, and adds the number of the others. */
export function shortNotes(notes: readonly string[]): string {
  let text = '';
  for (const [i, note] of notes.entries()) {
    const next = text ? `${text}; ${note}` : note;
    if (i > 0 && next.length > MAX_NOTES) return `${text}; ${notes.length - i} more behind “i”`;
    text = next;
  }
  return text;
}

/** The caption of a model. */
export interface CaptionContent {
  title: string;
  statistics: ModelStatistics;
  /** Notes to show at once, the most important first. */
  notes: readonly string[];
  /** Notes for the longer text. */
  details: readonly string[];
}

/** The caption of a model: its name and its most important notes, with a button for all notes and the statistics. */
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
    // Closes like a menu, when the user presses anything else.
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
    // Replaces the elements, because new text in the old ones would count as a layout shift.
    caption.replaceChildren(
      element('em', { id: 'model-name' }, shownName(content.title)),
      ' ',
      element('span', { id: 'model-note' }, shortNotes(content.notes.map(shownText))),
    );
    notes.replaceChildren(...all.map((note) => element('li', {}, shownText(note))));
    notes.hidden = all.length === 0;
    statistics.textContent = describe(content.statistics);
  }
}

/** Describes the statistics. Zero counts are left out. */
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
