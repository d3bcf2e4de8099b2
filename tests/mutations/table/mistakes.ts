import type { Mutation } from '../Mutation.js';

export const mistakes: readonly Mutation[] = [
  {
    name: 'a missing await is told each time',
    file: 'src/material/diagnostics/warn.ts',
    find: 'if (!hasWarned) warn',
    replace: 'warn',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/diagnostics/mistakes.test.ts',
      title: 'says so when its result is asked of it, once',
    },
  },
  {
    name: 'a silent library speaks',
    file: 'src/material/diagnostics/warn.ts',
    find: 'if (!silence.isOn) console',
    replace: 'console',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/diagnostics/mistakes.test.ts',
      title: 'a scene without a mesh is named',
    },
  },
  {
    name: 'an object is named without its place',
    file: 'src/material/diagnostics/describeObject.ts',
    find: 'object.parent.children.indexOf(object)',
    replace: '0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/material/diagnostics/describeObject.test.ts',
      title: 'one that is its own descendant is named, too',
    },
  },
];
