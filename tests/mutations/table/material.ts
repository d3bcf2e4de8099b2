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
      title: 'color … is refused, and the previous value stays',
    },
  },
  {
    name: 'tiles of a picture count from above',
    file: 'src/material/pictureOffset.ts',
    find: 'sheet.y -= ((fullHeight - offsetY - height)',
    replace: 'sheet.y -= ((offsetY)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/pictureOffset.test.ts',
      title: 'a tile of a larger one lies where it belongs, counted from below',
    },
  },
  {
    name: 'a hook has no source of its own',
    file: 'src/material/three/hooks.ts',
    find: 'hook.toString = () => String(set);',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/three/hooks.test.ts',
      title: 'a hook that was read can be set again, also on another material, and delete removes it',
    },
  },
  {
    name: 'defaults are written to JSON',
    file: 'src/material/hatchingJSON.ts',
    find: 'if (isTonalArtMap(value) || isDefault(name, value, material.technique)) continue;',
    replace: 'if (isTonalArtMap(value)) continue;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/hatchingJSON.test.ts',
      title: 'omits defaults, also those of a technique, and has all other values',
    },
  },
  {
    name: 'defaults of a technique are written to JSON',
    file: 'src/material/hatchingJSON.ts',
    find: 'value, material.technique)',
    replace: "value, 'hatching')",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/hatchingJSON.test.ts',
      title: 'omits defaults, also those of a technique, and has all other values',
    },
  },
  {
    name: 'a hook that is set again runs twice',
    file: 'src/material/three/hooks.ts',
    find: 'userHooks.has(value) ? (userHooks.get(value) as Hook) : value',
    replace: 'value',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/three/hooks.test.ts',
      title: 'runs once, also if a hook that was read is set again, any number of times',
    },
  },
];
