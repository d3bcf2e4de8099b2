import type { Mutation } from '../Mutation.js';

export const material: readonly Mutation[] = [
  {
    name: 'a number at the end of its range is refused',
    file: 'src/material/checkNumber.ts',
    find: 'value <= to',
    replace: 'value < to',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/properties.test.ts',
      title: 'color … is refused, and the one before stays',
    },
  },
  {
    name: 'tiles of a picture count from above',
    file: 'src/material/pictureOffset.ts',
    find: 'fullHeight - offsetY - height',
    replace: 'offsetY',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/pictureOffset.test.ts',
      title: 'a tile of a larger one lies where it belongs, counted from below',
    },
  },
  {
    name: 'a hook has no source of its own',
    file: 'src/material/keepHooks.ts',
    find: 'hook.toString = () => String(set);',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/keepHooks.test.ts',
      title: 'what was read can be set again, also on another material, and delete takes back what was set',
    },
  },
];
