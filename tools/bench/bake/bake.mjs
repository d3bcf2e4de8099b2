import { fitExponent, median } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const TORI = ['torus5k', 'torus20k', 'torus80k', 'torus245k', 'torus500k', 'torus980k'];
const DRAGONS = ['dragon11k', 'dragon48k', 'dragon202k', 'dragon871k'];
const HARD = ['fan100k', 'torus500kShuffled'];

const PLAN = { families: { torus: TORI, dragon: DRAGONS }, others: HARD, pages: 3, repeats: 4 };
const QUICK = { families: { torus: TORI.slice(0, 3) }, others: [], pages: 1, repeats: 3 };

/** The bake by phase, cold and warm, with the law by which each phase grows. */
export const bake = {
  name: 'bake',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const { families, others, pages, repeats } = isQuick ? QUICK : PLAN;
    const models = {};
    for (const model of [...Object.values(families).flat(), ...others]) {
      const runs = [];
      for (let page = 0; page < pages; page++) runs.push(await measure('bake', model, repeats));
      models[model] = summarise(runs);
    }
    const growth = Object.entries(families).map(([family, members]) => [
      family,
      growthOf(members.map((model) => models[model])),
    ]);
    return { pages, repeats, models, growth: Object.fromEntries(growth) };
  },

  describe({ pages, repeats, models, growth }) {
    const phases = Object.keys(Object.values(models)[0].cold);
    const times = (temperature) =>
      table([
        ['', 'triangles', ...phases],
        ...Object.entries(models).map(([model, row]) => [
          model,
          row.triangles.toLocaleString('en'),
          ...phases.map((phase) => figure(row[temperature][phase])),
        ]),
      ]);
    return `Cold, in ms: the first bake of a page, median of ${pages}.

${times('cold')}

Warm, in ms: the following ${repeats - 1} bakes of each page, median of all.

${times('warm')}

Growth: warm time ~ n^x, n the number of triangles; x with its 95 % interval.

${table([
  ['', ...phases],
  ...Object.entries(growth).map(([family, row]) => [family, ...phases.map((phase) => withInterval(row[phase]))]),
])}

Speed of a whole warm bake to the \`corner\` layout, the longest step between two yields, and visits of hash slots and half-edges.

${table([
  ['', 'million triangles/s', 'longest step, ms', 'visits per triangle'],
  ...Object.entries(models).map(([model, row]) => [
    model,
    figure(row.millionTrianglesPerSecond),
    figure(row.longestStep),
    figure(row.stepsPerTriangle),
  ]),
])}`;
  },
};

/** The phases that a bake to the `corner` layout goes through. */
const OF_CORNER = ['check', 'weld', 'pair', 'join', 'creases', 'normals', 'pack corner'];

function summarise(runs) {
  const { triangles, stepsPerTriangle } = runs[0];
  const later = runs.flatMap(({ times }) => times.slice(1));
  const warm = medians(later);
  const whole = median(later.map((times) => OF_CORNER.reduce((sum, phase) => sum + times[phase], 0)));
  return {
    triangles,
    cold: medians(runs.map(({ times }) => times[0])),
    warm,
    millionTrianglesPerSecond: triangles / whole / 1000,
    longestStep: Math.max(...runs.flatMap(({ longestSteps }) => longestSteps.slice(1))),
    stepsPerTriangle,
  };
}

const medians = (runs) =>
  Object.fromEntries(Object.keys(runs[0]).map((phase) => [phase, median(runs.map((times) => times[phase]))]));

const growthOf = (rows) =>
  Object.fromEntries(
    Object.keys(rows[0].warm).map((phase) => [
      phase,
      fitExponent(rows.map(({ triangles, warm }) => [triangles, warm[phase]])),
    ]),
  );
