import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 25 }, size: 1024 };
const QUICK = { models: { dragon11k: 2 }, size: 128 };

/** The baseline of the comparison. */
const BASE = 'hatching';

/** Frames of every medium beside `hatching`. */
export const media = {
  name: 'media',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { models, size } = isQuick ? QUICK : PLAN;
    const results = {};
    for (const [model, turns] of Object.entries(models)) {
      const { triangles, times } = await measure('media', model, turns, size);
      const drawn = Object.entries(times).map(([name, list]) => [
        name,
        { ms: median(list), ratio: medianInterval(ratios(list, times[BASE])) },
      ]);
      results[model] = { triangles, turns, drawn: Object.fromEntries(drawn) };
    }
    return { size, models: results };
  },

  describe({ size, models }) {
    const names = Object.keys(Object.values(models)[0].drawn);
    return `${size} × ${size} pixels, sized on the screen, layout \`indexed\`; ratios to \`hatching\`.

${table([
  ['', 'triangles', 'turns', 'hatching, ms', ...names.filter((name) => name !== BASE)],
  ...Object.entries(models).map(([model, { triangles, turns, drawn }]) => [
    model,
    triangles.toLocaleString('en'),
    String(turns),
    figure(drawn[BASE].ms),
    ...names.filter((name) => name !== BASE).map((name) => withInterval(drawn[name].ratio)),
  ]),
])}`;
  },
};
