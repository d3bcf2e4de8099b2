import type { Mutation } from '../Mutation.js';

export const react: readonly Mutation[] = [
  {
    name: 'a veiled mesh comes back in all layers',
    file: 'src/react/Hatcher.ts',
    find: 'object.layers.mask = mask;',
    replace: 'object.layers.mask = -1;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/Hatcher.test.ts',
      title: 'a helper may swap materials of its own and of others: it is left alone, and nothing is hatched again',
    },
  },
  {
    name: 'an option that is left out keeps its value',
    file: 'src/react/Hatcher.ts',
    find: '{ ...NO_OPTIONS, ...options }',
    replace: '{ ...options }',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/Hatcher.test.ts',
      title: 'a technique that needs other geometry, other creases and other options of the bake hatch anew',
    },
  },
  {
    name: 'a form that was baked later is baked again with every change',
    file: 'src/scene/makeLooks.ts',
    find: 'if (!isThat(plan) && !isThat(plans.get(source)!)) continue;',
    replace: 'if (!isThat(plan)) continue;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/Hatcher.test.ts',
      title: 'a large mesh that follows the form only later is drawn once more, and not hatched again',
    },
  },
  {
    name: 'lists differ though they hold the same',
    file: 'src/react/sameValue.ts',
    find: 'Array.isArray(a) && Array.isArray(b)',
    replace: 'Array.isArray(a) && a === b',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/sameValue.test.ts',
      title: 'options are the same by what they hold, whatever they are made of',
    },
  },
  {
    name: 'a longer list is the same',
    file: 'src/react/sameValue.ts',
    find: 'a.length === b.length && ',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/sameValue.test.ts',
      title: 'options differ in a value, a length, a name, or a kind',
    },
  },
  {
    name: 'functions that a component makes anew differ',
    file: 'src/react/sameValue.ts',
    find: "if (typeof a === 'function' && typeof b === 'function') return true;",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/sameValue.test.ts',
      title: 'options are the same by what they hold, whatever they are made of',
    },
  },
  {
    name: 'what is added to options is not seen',
    file: 'src/react/sameValue.ts',
    find: '[...new Set([...Object.keys(a), ...Object.keys(b)])]',
    replace: 'Object.keys(a)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/sameValue.test.ts',
      title: 'options differ in a value, a length, a name, or a kind',
    },
  },
];
