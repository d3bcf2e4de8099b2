import type { Mutation } from '../Mutation.js';

export const detail: readonly Mutation[] = [
  {
    name: 'levels change to and fro',
    file: 'src/mesh/detail/chooseLevel.ts',
    find: 'i > before ? CALM * MOST_PIXELS',
    replace: 'i < before ? CALM * MOST_PIXELS',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/detail/chooseLevel.test.ts',
      title: 'levels do not flicker while the distance varies around the boundary of two levels',
    },
  },
  {
    name: 'a level is as far off as its error is small',
    file: 'src/mesh/detail/chooseLevel.ts',
    find: 'levels[i].error * pixelsPerUnit',
    replace: 'levels[i].error / pixelsPerUnit',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/mesh/detail/chooseLevel.test.ts',
      title: 'levels do not flicker while the distance varies around the boundary of two levels',
    },
  },
];
