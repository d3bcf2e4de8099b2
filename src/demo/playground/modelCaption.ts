import type { ModelStatistics } from '../drawing/HatchedModel.js';

/**
 * The name of a model and what it is made of, for the caption. New elements rather than new text in the old ones: nothing
 * on the page then counts as having moved.
 */
export function modelCaption(name: string, statistics: ModelStatistics, broken: number): (HTMLElement | string)[] {
  const nameElement = Object.assign(document.createElement('em'), { id: 'model-name', textContent: name });
  const factsElement = Object.assign(document.createElement('span'), {
    id: 'model-statistics',
    textContent: describeModel(statistics, broken),
  });
  return [nameElement, ' ', factsElement];
}

/** One quiet line on what a model is made of; what there is none of is not mentioned. */
function describeModel(statistics: ModelStatistics, broken: number): string {
  const parts = [
    count(statistics.triangles, 'triangle'),
    count(statistics.borderEdges, 'border edge'),
    count(statistics.nonManifoldEdges, 'odd edge'),
    statistics.degenerateTriangles > 0 ? `${statistics.degenerateTriangles.toLocaleString('en')} without area` : '',
    broken > 0 ? `${broken.toLocaleString('en')} broken ${broken === 1 ? 'one' : 'ones'} left out` : '',
  ];
  return parts.filter(Boolean).join(', ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
