import { median } from '../statistics.mjs';
import { figure, table } from '../table.mjs';

const STYLES = [
  'hatching',
  'crossHatching',
  'tripleHatching',
  'ruled',
  'contours',
  'dashes',
  'stippling',
  'pencil',
  'charcoal',
  'woodcut',
];
const LARGE = ['hatching', 'crossHatching', 'stippling'];
const PLAN = [
  ...STYLES.map((style) => ({ style, size: 256, repeats: 4 })),
  ...LARGE.map((style) => ({ style, size: 1024, repeats: 2 })),
];
const QUICK = LARGE.map((style) => ({ style, size: 64, repeats: 2 }));

/** The drawing of tonal art maps: the hatch images and the thresholds. */
export const tam = {
  name: 'tam',
  perRasteriser: false,

  async run({ measure }, isQuick) {
    const maps = {};
    for (const { style, size, repeats } of isQuick ? QUICK : PLAN) {
      const { times, longestSteps } = await measure('map', { style, size }, repeats);
      const warm = (phase) => median(times.slice(1).map((run) => run[phase]));
      maps[`${style} ${size}`] = {
        cold: times[0].images + times[0].thresholds,
        images: warm('images'),
        thresholds: warm('thresholds'),
        longestStep: Math.max(...longestSteps.slice(1)),
      };
    }
    return { maps };
  },

  describe({ maps }) {
    return `ms on one thread. Cold is the first map of a page, images and thresholds together; warm the median of the others, three at a size of 256.

${table([
  ['', 'cold', 'images, warm', 'thresholds, warm', 'longest step'],
  ...Object.entries(maps).map(([name, { cold, images, thresholds, longestStep }]) => [
    name,
    ...[cold, images, thresholds, longestStep].map(figure),
  ]),
])}`;
  },
};
