import type { Mutation } from '../Mutation.js';

export const strokes: readonly Mutation[] = [
  {
    name: 'a tent filter is moved by a texel',
    file: 'src/strokes/blurToroidal.ts',
    find: 'row[(x + radius) & mask] * scale',
    replace: 'row[(x + radius + 1) & mask] * scale',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/blurToroidal.test.ts',
      title: 'spreads a texel into a tent of radius … , around the corner',
    },
  },
  {
    name: 'random numbers follow another sequence',
    file: 'src/strokes/random.ts',
    find: '0x9e3779b9',
    replace: '0x9e3779b1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/random.test.ts',
      title: 'never changes its numbers, since saved seeds must keep their drawings',
    },
  },
  {
    name: 'the paper has other peaks after a half turn',
    file: 'src/strokes/paperGrain.ts',
    find: 'depths[order[rank]] = depths[last - order[rank]] = depth',
    replace: 'depths[order[rank]] = depth',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/paperGrain.test.ts',
      title: 'takes less ink from a stroke that presses less, and none beside it',
    },
  },
  {
    name: 'a stroke is drawn on its own level alone',
    file: 'src/strokes/placeStrokes.ts',
    find: 'for (let finer = level; finer >= 0; finer--) {\n          for (const addedStroke',
    replace: 'for (let finer = level; finer >= level; finer--) {\n          for (const addedStroke',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/placeStrokes.test.ts',
      title: 'spreads … s more evenly than chance: less than 0.8 of its unevenness',
    },
  },
  {
    name: 'pairs of strokes have one stroke',
    file: 'src/strokes/placeStrokes.ts',
    find: 'pairs ? [stroke, halfTurn(stroke)] : [stroke]',
    replace: '[stroke]',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/placeStrokes.test.ts',
      title: 'draws … in pairs that a half turn swaps, if asked',
    },
  },
  {
    name: 'layers begin with the second tone',
    file: 'src/strokes/placeStrokes.ts',
    find: 'target > layers[i].from &&',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/strokes/placeStrokes.test.ts',
      title: 'draws three directions sixty degrees apart, one after the other, for a triple hatching',
    },
  },
  {
    name: 'lattices of strokes on the screen change places',
    file: 'shaders/techniques/strokes/strokes.glsl',
    find: '(i == 0.0 ? 1.0 - fade : fade)',
    replace: '(i == 0.0 ? fade : 1.0 - fade)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title: 'hatching equals the double-precision reference: …sized half on the screen, two lights',
    },
  },
];
