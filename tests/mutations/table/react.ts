import type { Mutation } from '../Mutation.js';

export const react: readonly Mutation[] = [
  {
    name: 'a veiled mesh comes back in all layers',
    file: 'src/react/Veil.ts',
    find: 'mesh.layers.mask = mask;',
    replace: 'mesh.layers.mask = -1;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/react/Hatcher.test.ts',
      title: 'a helper may swap materials of its own and of others: it is left alone, and nothing is hatched again',
    },
  },
];
