import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = { models: { dragon11k: 25, dragon48k: 15, dragon871k: 15 }, moving: 'dragon48k', size: 1024 };
const QUICK = { models: { torus5k: 2 }, moving: '', size: 128 };

/** The baseline of the comparison: the same mesh without lines. */
const WITHOUT = {
  'with lines': 'hatched',
  'with lines, no list': 'hatched',
  'instance with lines': 'instance',
  'skinned with lines': 'skinned',
};

/** The cost of contours and feature edges, compared with the frame without them. */
export const lines = {
  name: 'lines',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { models, moving, size } = isQuick ? QUICK : PLAN;
    const results = {};
    for (const [model, turns] of Object.entries(models)) {
      const { times, script, ...counts } = await measure('lines', model, turns, size, model === moving);
      const drawn = Object.entries(WITHOUT)
        .filter(([name]) => times[name])
        .map(([name, without]) => [
          name,
          { ms: median(times[name]), ratio: medianInterval(ratios(times[name], times[without])) },
        ]);
      const sorted = script.toSorted((a, b) => a - b);
      const scriptTimes = { median: median(script), p95: sorted[Math.floor(0.95 * sorted.length)] };
      results[model] = { ...counts, turns, script: scriptTimes, drawn: Object.fromEntries(drawn) };
    }
    return { size, models: results };
  },

  describe({ size, models }) {
    const names = Object.keys(WITHOUT);
    return `${size} × ${size} pixels, \`hatching\` on the layout \`indexed\`; ratios to the same mesh without lines. Script: what the lines take on the
main thread per frame while the camera turns by 1° a frame.

${table([
  ['', 'triangles', 'listed', 'turns', ...names, 'script, ms: median', '95 %'],
  ...Object.entries(models).map(([model, { triangles, listed, primitives, turns, script, drawn }]) => [
    model,
    triangles.toLocaleString('en'),
    `${((100 * listed) / primitives).toFixed(1)} %`,
    String(turns),
    ...names.map((name) => (drawn[name] ? withInterval(drawn[name].ratio) : '')),
    figure(script.median),
    figure(script.p95),
  ]),
])}`;
  },
};
