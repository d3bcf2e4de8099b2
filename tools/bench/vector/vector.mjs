import { median } from '../statistics.mjs';
import { figure, table } from '../table.mjs';

const PLAN = { dragon11k: 3, dragon48k: 3, dragon871k: 1 };
const QUICK = { dragon11k: 1 };

/** The time of vector drawings in a worker: with the bake, and compared with each other. */
export const vector = {
  name: 'vector',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const rows = {};
    for (const [model, repeats] of Object.entries(isQuick ? QUICK : PLAN)) {
      const { triangles, drawings } = await measure('vector', model, repeats);
      const without = median(drawings.light.times);
      rows[model] = {
        triangles,
        drawings: Object.fromEntries(
          Object.entries(drawings).map(([name, { bake, times, ...counts }]) => [
            name,
            { ...counts, bake, drawing: median(times), ratio: median(times) / without },
          ]),
        ),
      };
    }
    return rows;
  },

  describe(rows) {
    return `A sheet of 200 mm, the preset \`engraving\`, outlines included. Ratio: to the drawing with \`direction: 'light'\` without shadows, in the same run.

${table([
  ['', 'triangles', 'lines', 'bake, s', 'drawing, s', 'ratio', 'paths', 'kB'],
  ...Object.entries(rows).flatMap(([model, { triangles, drawings }]) =>
    Object.entries(drawings).map(([name, { bake, drawing, ratio, paths, kilobytes }]) => [
      model,
      triangles.toLocaleString('en'),
      name,
      figure(bake / 1000),
      figure(drawing / 1000),
      figure(ratio),
      paths.toLocaleString('en'),
      figure(kilobytes),
    ]),
  ),
])}`;
  },
};
