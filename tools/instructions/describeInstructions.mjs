import { table } from '../bench/table.mjs';

/** The lines of the document between which the figures stand. */
const START = '<!-- Written by npm run instructions. -->';
const END = '<!-- Until here. -->';

/** A table of all looks, as multiples of Phong under the same circumstances. */
export function describeInstructions({ commit, date, model, size, cases }) {
  const { phong, ...looks } = cases;
  const cell = (look, chip, count) => times(looks[look][chip][count] / phong[chip][count]);
  return `Commit ${commit}, ${date}: ${model} on ${size} × ${size} pixels, lit by one directional light.

${table([
  [
    '',
    'Tiger Lake, compiled',
    'executed',
    'pixels at a time',
    'RDNA 2, compiled',
    'executed',
    'registers',
    'pixels at a time',
  ],
  ...Object.entries(looks).map(([look, { intel, amd }]) => [
    look === 'default' ? 'no preset' : `\`${look}\``,
    cell(look, 'intel', 'compiled'),
    cell(look, 'intel', 'executed'),
    String(intel.width),
    cell(look, 'amd', 'compiled'),
    cell(look, 'amd', 'executed'),
    String(amd.registers),
    String(amd.width),
  ]),
])}`;
}

/**
 * A document with its figures replaced.
 *
 * @throws if it has no place for them
 */
export function withInstructions(document, results) {
  const [start, end] = [document.indexOf(START), document.indexOf(END)];
  if (start < 0 || end < start) throw new Error(`withInstructions: the document lacks "${START}" and "${END}".`);
  return `${document.slice(0, start + START.length)}\n\n${describeInstructions(results)}\n\n${document.slice(end)}`;
}

const times = (value) => (value >= 9.95 ? value.toFixed(0) : value.toFixed(1));
