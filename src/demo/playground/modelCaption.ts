import type { ModelFacts } from '../drawing/DrawnModel.js';

/**
 * The name of a model and what it is made of, for the caption. New elements rather than new text in the old ones: nothing
 * on the page then counts as having moved.
 */
export function modelCaption(name: string, facts: ModelFacts, broken: number): (HTMLElement | string)[] {
  const nameElement = Object.assign(document.createElement('em'), { id: 'model-name', textContent: name });
  const factsElement = Object.assign(document.createElement('span'), {
    id: 'model-facts',
    textContent: describeModel(facts, broken),
  });
  return [nameElement, ' ', factsElement];
}

/** One quiet line on what a model is made of; what there is none of is not mentioned. */
function describeModel(made: ModelFacts, broken: number): string {
  const facts = [
    count(made.triangles, 'triangle'),
    count(made.borderEdges, 'border edge'),
    count(made.nonManifoldEdges, 'odd edge'),
    made.degenerateTriangles > 0 ? `${made.degenerateTriangles.toLocaleString('en')} without area` : '',
    broken > 0 ? `${broken.toLocaleString('en')} broken ${broken === 1 ? 'one' : 'ones'} left out` : '',
  ];
  return facts.filter(Boolean).join(', ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
