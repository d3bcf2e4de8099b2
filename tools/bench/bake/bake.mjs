import { fitExponent, median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const TORI = ['torus5k', 'torus20k', 'torus80k', 'torus245k', 'torus500k', 'torus980k'];
const DRAGONS = ['dragon11k', 'dragon48k', 'dragon202k', 'dragon871k'];
const HARD = ['fan100k', 'torus500kShuffled'];

/** Meshes from the smallest for which the speed of the bake is promised. */
const WHOLE = ['torus80k', 'torus245k', 'torus500k', 'torus980k', 'dragon48k', 'dragon202k', 'dragon871k'];

const PLAN = {
  families: { torus: TORI, dragon: DRAGONS },
  others: HARD,
  pages: 3,
  repeats: 4,
  whole: { models: WHOLE, turns: 9 },
  scale: { triangles: [1e6, 1e7], turns: 6 },
};
const QUICK = {
  families: { torus: TORI.slice(0, 3) },
  others: [],
  pages: 1,
  repeats: 2,
  whole: { models: ['torus5k', 'torus20k', 'torus80k'], turns: 2 },
  scale: { triangles: [1e4, 1e5], turns: 2 },
};

/** The bake by phase, cold and warm, with the law by which each phase grows. */
export const bake = {
  name: 'bake',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const { families, others, pages, repeats, whole, scale } = isQuick ? QUICK : PLAN;
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
    return {
      pages,
      repeats,
      models,
      growth: Object.fromEntries(growth),
      whole: await measureWhole(measure, whole),
      scale: compareSizes(await measure('wholeBake', scale.triangles, scale.turns)),
    };
  },

  describe(result) {
    const { pages, repeats, models, growth } = result;
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
])}${describeWhole(result)}`;
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

/** Results that were kept before whole bakes were measured have none. */
function describeWhole({ whole, scale }) {
  if (!whole) return '';
  return `

A whole bake to the \`indexed\` layout, without and with outlines: the median of ${whole.turns} turns with its 95 % interval. In each turn all
models are baked one after the other.

${table([
  ['', 'triangles', 'ms', 'million triangles/s', 'with outlines, ms', 'million triangles/s'],
  ...Object.entries(whole.models).map(([model, { triangles, plain, outlined }]) => [
    model,
    triangles.toLocaleString('en'),
    withInterval(plain.ms, 0),
    withInterval(plain.speed),
    withInterval(outlined.ms, 0),
    withInterval(outlined.speed),
  ]),
])}

Growth of its time: n^x, x with its 95 % interval.

${table([
  ['', 'x', 'with outlines'],
  ...Object.entries(whole.growth).map(([family, { plain, outlined }]) => [
    family,
    withInterval(plain),
    withInterval(outlined),
  ]),
])}

The time per triangle on a torus of ${scale.triangles[1].toLocaleString('en')} triangles, compared with one of
${scale.triangles[0].toLocaleString('en')}: ${withInterval(scale.plain)}, with outlines ${withInterval(scale.outlined)}.`;
}

const KINDS = ['plain', 'outlined'];

async function measureWhole(measure, { models, turns }) {
  const results = await measure('wholeBake', models, turns);
  const rows = results.map(({ triangles, ...times }) => ({
    triangles,
    ...Object.fromEntries(KINDS.map((kind) => [kind, timesOf(triangles, times[kind])])),
  }));
  const familyOf = (model) => /^[a-z]+/.exec(model)[0];
  const families = [...new Set(models.map(familyOf))];
  const growth = families.map((family) => [family, wholeGrowth(rows.filter((_, i) => familyOf(models[i]) === family))]);
  return {
    turns,
    models: Object.fromEntries(models.map((model, i) => [model, rows[i]])),
    growth: Object.fromEntries(growth),
  };
}

const timesOf = (triangles, times) => ({
  ms: medianInterval(times),
  speed: medianInterval(times.map((ms) => triangles / ms / 1000)),
});

const wholeGrowth = (rows) =>
  Object.fromEntries(KINDS.map((kind) => [kind, fitExponent(rows.map((row) => [row.triangles, row[kind].ms[0]]))]));

/** The ratios, with their intervals, of the times per triangle on the larger and on the smaller mesh of the same turn. */
function compareSizes([small, large]) {
  const perTriangle = ({ triangles }, times) => times.map((ms) => ms / triangles);
  return {
    triangles: [small.triangles, large.triangles],
    ...Object.fromEntries(
      KINDS.map((kind) => [
        kind,
        medianInterval(ratios(perTriangle(large, large[kind]), perTriangle(small, small[kind]))),
      ]),
    ),
  };
}
