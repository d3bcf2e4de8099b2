import type { Mutation } from '../Mutation.js';

export const scan: readonly Mutation[] = [
  {
    name: 'lines are thinned in one half step alone',
    file: 'src/strokes/strokeTracing/thin.ts',
    find: 'halves[1][bits] = Number(isBorder && !(above && right && left) && !(above && below && left))',
    replace: 'halves[1][bits] = halves[0][bits]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/strokeTracing/thin.test.ts',
      title: 'a bar becomes a line along its middle',
    },
  },
  {
    name: 'corners stay in thin lines',
    file: 'src/strokes/strokeTracing/thin.ts',
    find: 'if (rules.corner[neighboursOf(mask, pixel, around)]) mask[pixel] = 0;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/strokeTracing/thin.test.ts',
      title: 'a staircase keeps no corners: inside a line every pixel has two neighbours',
    },
  },
  {
    name: 'ink is found at half the depth',
    file: 'src/strokes/strokeTracing/findInk.ts',
    find: 'Math.min(fullDepth, 1.1 *',
    replace: 'Math.max(fullDepth, 1.1 *',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/strokeTracing/traceStrokes.test.ts',
      title: 'a stroke that swells from point to point keeps its points, its bend and its width',
    },
  },
];
