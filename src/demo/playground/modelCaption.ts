import type { ModelStatistics } from '../drawing/HatchedModel.js';
import { shownName, shownText } from '../files/shownText.js';

/**
 * The caption of a model: its name, its statistics, and notes on what was left out. They are new elements, because new text in the old ones would count
 * as a layout shift.
 */
export function modelCaption(
  name: string,
  statistics: ModelStatistics,
  notes: readonly string[],
): (HTMLElement | string)[] {
  const nameElement = Object.assign(document.createElement('em'), { id: 'model-name', textContent: shownName(name) });
  const factsElement = Object.assign(document.createElement('span'), {
    id: 'model-statistics',
    textContent: describeModel(statistics, notes),
  });
  return [nameElement, ' ', factsElement];
}

/** The statistics in words, and the notes. Counts of zero are left out. */
function describeModel(statistics: ModelStatistics, notes: readonly string[]): string {
  const parts = [
    count(statistics.triangles, 'triangle'),
    count(statistics.borderEdges, 'border edge'),
    count(statistics.nonManifoldEdges, 'non-manifold edge'),
    statistics.degenerateTriangles > 0 ? `${statistics.degenerateTriangles.toLocaleString('en')} without area` : '',
  ];
  return [parts.filter(Boolean).join(', '), ...notes.map(shownText)].join('; ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
