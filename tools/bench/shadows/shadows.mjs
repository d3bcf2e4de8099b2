import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 25 }, size: 1024 };
const QUICK = { models: { dragon11k: 7 }, size: 512 };

/** What shadows cost: on a model that casts shadows on itself, and on a ground that shows nothing but shadows. */
export const shadows = {
  name: 'shadows',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { models, size } = isQuick ? QUICK : PLAN;
    const results = {};
    for (const [model, turns] of Object.entries(models)) {
      const { times, against, triangles } = await measure('shadows', model, turns, size);
      const drawn = Object.entries(times).map(([name, list]) => [
        name,
        { ms: median(list), to: against[name], ratio: medianInterval(ratios(list, times[against[name]])) },
      ]);
      results[model] = { triangles, turns, drawn: Object.fromEntries(drawn) };
    }
    return { size, models: results };
  },

  describe({ size, models }) {
    const parts = Object.entries(models).map(
      ([model, { triangles, turns, drawn }]) => `${model}, ${triangles.toLocaleString('en')} triangles, ${turns} turns:

${table([
  ['', 'ms', 'to', 'ratio'],
  ...Object.entries(drawn).map(([name, { ms, to, ratio }]) => [
    name,
    figure(ms),
    to === name ? '' : to,
    to === name ? '1' : withInterval(ratio),
  ]),
])}`,
    );
    return `${size} × ${size} pixels.\n\n${parts.join('\n\n')}`;
  },
};
