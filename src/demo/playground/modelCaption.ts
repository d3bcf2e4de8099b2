import type { ModelStatistics } from '../drawing/HatchedModel.js';

/**
 * The caption of a model: its name and statistics. They are new elements, because new text in the old ones would count
 * as a layout shift.
 */
export function modelCaption(name: string, statistics: ModelStatistics, broken: number): (HTMLElement | string)[] {
  const nameElement = Object.assign(document.createElement('em'), { id: 'model-name', textContent: name });
  const factsElement = Object.assign(document.createElement('span'), {
    id: 'model-statistics',
    textContent: describeModel(statistics, broken),
  });
  return [nameElement, ' ', factsElement];
}

/** The statistics in words. Counts of zero are left out. */
function describeModel(statistics: ModelStatistics, broken: number): string {
  const parts = [
    count(statistics.triangles, 'triangle'),
    count(statistics.borderEdges, 'border edge'),
    count(statistics.nonManifoldEdges, 'non-manifold edge'),
    statistics.degenerateTriangles > 0 ? `${statistics.degenerateTriangles.toLocaleString('en')} without area` : '',
    broken > 0 ? `${broken.toLocaleString('en')} broken ${broken === 1 ? 'one' : 'ones'} left out` : '',
  ];
  return parts.filter(Boolean).join(', ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
