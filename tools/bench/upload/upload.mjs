import { fitExponent, median } from '../statistics.mjs';
import { figure, table, withInterval } from '../table.mjs';

const LAYOUTS = ['corner', 'pull', 'indexed'];
const PLAN = { models: ['torus80k', 'torus245k', 'torus500k', 'torus980k'], repeats: 8 };
const QUICK = { models: ['torus20k'], repeats: 4 };

/** The time that the first frame waits for the upload of the geometry. */
export const upload = {
  name: 'upload',
  perRasteriser: true,

  async run({ measure }, isQuick) {
    const { models, repeats } = isQuick ? QUICK : PLAN;
    const layouts = {};
    for (const layout of LAYOUTS) {
      layouts[layout] = {};
      for (const model of models) {
        const { bytes, times } = await measure('upload', model, layout, repeats);
        layouts[layout][model] = { bytes, cold: times[0], warm: median(times.slice(1)) };
      }
    }
    return { repeats, layouts };
  },

  describe({ repeats, layouts }) {
    const models = Object.keys(layouts.corner);
    return `ms, cold / warm: the first upload of a page, and the median of the ${repeats - 1} that follow. In the last row, warm time ~ bytes^x.

${table([
  ['', ...LAYOUTS.flatMap((layout) => [`${layout}, MB`, 'ms'])],
  ...models.map((model) => [
    model,
    ...LAYOUTS.flatMap((layout) => {
      const { bytes, cold, warm } = layouts[layout][model];
      return [figure(bytes / 1e6), `${figure(cold)} / ${figure(warm)}`];
    }),
  ]),
  ['x', ...LAYOUTS.flatMap((layout) => ['', growth(layouts[layout])])],
])}`;
  },
};

function growth(rows) {
  const points = Object.values(rows)
    .filter(({ warm }) => warm > 0)
    .map(({ bytes, warm }) => [bytes, warm]);
  return points.length > 2 ? withInterval(fitExponent(points)) : '';
}
