import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = {
  turns: { dragon11k: 25, dragon48k: 25, dragon202k: 15, torus500k: 15, dragon871k: 15 },
  size: 1024,
};
const QUICK = { turns: { dragon11k: 2 }, size: 128 };

/** The baseline of the comparison. */
const REFERENCES = ['phong corner', 'phong indexed', 'adjacency corner'];

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
  ['', 'ms', ...REFERENCES.map((reference) => `to ${reference}`)],
  ...Object.entries(drawn).map(([name, { ms, to }]) => [
    name,
    figure(ms),
    ...REFERENCES.map((reference) => (reference === name ? '1' : withInterval(to[reference]))),
  ]),
])}`,
    );
    return `${size} × ${size} pixels.\n\n${parts.join('\n\n')}`;
  },
};

/** Median times, and ratios within a turn. */
function summarise({ triangles, times }, turns) {
  const drawn = Object.entries(times).map(([name, list]) => {
    const to = REFERENCES.map((reference) => [reference, medianInterval(ratios(list, times[reference]))]);
    return [name, { ms: median(list), to: Object.fromEntries(to) }];
  });
  return { triangles, turns, drawn: Object.fromEntries(drawn) };
}
