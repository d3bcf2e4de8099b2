import type { DrawnModel } from './DrawnModel.js';

/** One quiet line on what a model is made of; what there is none of is not mentioned. */
export function describeModel(model: DrawnModel, broken: number): string {
  const facts = [
    count(model.triangles, 'triangle'),
    count(model.borderEdges, 'border edge'),
    count(model.nonManifoldEdges, 'odd edge'),
    model.degenerateTriangles > 0 ? `${model.degenerateTriangles.toLocaleString('en')} without area` : '',
    broken > 0 ? `${broken.toLocaleString('en')} broken ${broken === 1 ? 'one' : 'ones'} left out` : '',
  ];
  return facts.filter(Boolean).join(', ');
}

function count(number: number, noun: string): string {
  if (number === 0) return '';
  return `${number.toLocaleString('en')} ${noun}${number === 1 ? '' : 's'}`;
}
