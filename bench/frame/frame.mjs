import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = {
  turns: { dragon11k: 25, dragon48k: 25, dragon202k: 15, torus500k: 15, dragon871k: 15 },
  size: 1024,
};
const QUICK = { turns: { dragon11k: 5 }, size: 512 };

/** Frames of all techniques and layouts beside three's Phong material. */
export const frame = {
  name: 'frame',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { turns, size } = isQuick ? QUICK : PLAN;
    const models = {};
    for (const [model, count] of Object.entries(turns)) {
      models[model] = summarise(await measure('frames', model, count, size), count);
    }
    return { size, models };
  },

  describe({ size, models }) {
    const parts = Object.entries(models).map(
      ([model, { triangles, turns, drawn }]) => `${model}, ${triangles.toLocaleString('en')} triangles, ${turns} turns:

${table([
  ['', 'ms', 'to Phong, corner', 'to Phong, indexed'],
  ...Object.entries(drawn).map(([name, { ms, toCorner, toIndexed }]) => [
    name,
    figure(ms),
    withInterval(toCorner),
    withInterval(toIndexed),
  ]),
])}`,
    );
    return `${size} × ${size} pixels.\n\n${parts.join('\n\n')}`;
  },
};

/** Median times, and ratios within a turn to Phong on the same expanded and on the plain indexed geometry. */
function summarise({ triangles, times }, turns) {
  const drawn = Object.entries(times).map(([name, list]) => [
    name,
    {
      ms: median(list),
      toCorner: medianInterval(ratios(list, times['phong corner'])),
      toIndexed: medianInterval(ratios(list, times['phong indexed'])),
    },
  ]);
  return { triangles, turns, drawn: Object.fromEntries(drawn) };
}
