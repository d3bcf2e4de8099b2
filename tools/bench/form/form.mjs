import { fitExponent, median } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const DRAGONS = ['dragon11k', 'dragon48k', 'dragon202k', 'dragon871k'];
const PLAN = { models: [...DRAGONS, 'torus20k', 'torus245k', 'torus980k', 'torus5000k'], repeats: 3 };
const QUICK = { models: DRAGONS.slice(0, 3), repeats: 2 };

const PHASES = ['surface', 'directions', 'cut', 'lines'];

/** The bake of the field of lines that follow the form, both families, by phase. */
export const form = {
  name: 'form',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const { models, repeats } = isQuick ? QUICK : PLAN;
    const rows = {};
    for (const model of models) rows[model] = summarise(await measure('form', model, repeats));
    const growth = fitExponent(
      DRAGONS.flatMap((model) => (rows[model] ? [[rows[model].triangles, rows[model].whole]] : [])),
    );
    return { repeats, models: rows, growth };
  },

  describe({ repeats, models, growth }) {
    return `Warm, in ms for 100,000 triangles: median of the ${repeats - 1} bakes after the first. The last column of times is the whole first bake.

${table([
  ['', 'triangles', ...PHASES, 'whole', 'cold', 'longest step, ms', 'singular points', 'added vertices'],
  ...Object.entries(models).map(([model, row]) => {
    const per100k = (time) => figure((1e5 * time) / row.triangles);
    return [
      model,
      row.triangles.toLocaleString('en'),
      ...PHASES.map((phase) => per100k(row.times[phase])),
      per100k(row.whole),
      per100k(row.cold),
      figure(row.longestStep),
      String(row.singularPoints),
      `${figure((100 * row.addedVertices) / row.vertices)} %`,
    ];
  }),
])}

Growth of the dragons: warm time ~ n^x, n the number of triangles; x is ${withInterval(growth)}.`;
  },
};

const wholeOf = (times) => PHASES.reduce((sum, phase) => sum + times[phase], 0);

function summarise({ triangles, times, longestSteps, vertices, singularPoints, addedVertices }) {
  const [first, ...later] = times;
  return {
    triangles,
    times: Object.fromEntries(PHASES.map((phase) => [phase, median(later.map((run) => run[phase]))])),
    whole: median(later.map(wholeOf)),
    cold: wholeOf(first),
    longestStep: median(longestSteps.slice(1)),
    vertices,
    singularPoints,
    addedVertices,
  };
}
