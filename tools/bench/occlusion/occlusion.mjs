import { median, medianInterval, ratios } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const PLAN = { models: ['dragon48k', 'dragon202k'], repeats: 3, turns: 15, size: 1024 };
const QUICK = { models: ['dragon11k'], repeats: 1, turns: 2, size: 128 };

/** The time of a bake of occlusion, and its cost in a frame. */
export const occlusion = {
  name: 'occlusion',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const { models, repeats, turns, size } = isQuick ? QUICK : PLAN;
    const results = {};
    for (const model of models) {
      const { triangles, passes, longest, times } = await measure('occlusion', model, repeats, turns, size);
      const frames = Object.entries(times).map(([name, { open, occluded }]) => [
        name,
        medianInterval(ratios(occluded, open)),
      ]);
      results[model] = {
        triangles,
        passes: passes[0].map((_, i) => median(passes.map((one) => one[i]))),
        longest,
        frames: Object.fromEntries(frames),
      };
    }
    return { repeats, turns, size, models: results };
  },

  describe({ repeats, turns, size, models }) {
    const [{ frames }] = Object.values(models);
    return `Milliseconds until each result is shown, medians of ${repeats}; the longest task of the main thread meanwhile, 0 where none took 50 ms; and
frames with occlusion to the same without, ${turns} turns of ${size} × ${size} pixels.

${table([
  ['', 'triangles', 'first', 'second', 'last', 'longest task', ...Object.keys(frames)],
  ...Object.entries(models).map(([model, one]) => [
    model,
    one.triangles.toLocaleString('en'),
    ...one.passes.map(figure),
    figure(one.longest),
    ...Object.values(one.frames).map((interval) => withInterval(interval)),
  ]),
])}`;
  },
};
