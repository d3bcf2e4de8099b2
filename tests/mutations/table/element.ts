import type { Mutation } from '../Mutation.js';

export const element: readonly Mutation[] = [
  {
    name: 'an elevation of 90° is refused',
    file: 'src/element/readAttributes.ts',
    find: '<= MAX_ELEVATION',
    replace: '< MAX_ELEVATION',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/element/readAttributes.test.ts',
      title: "'720 -90' … is azimuth and elevation",
    },
  },
  {
    name: 'an exposure of 0 is allowed',
    file: 'src/element/readAttributes.ts',
    find: 'value > 0 && value < Infinity',
    replace: 'value >= 0 && value < Infinity',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/element/readAttributes.test.ts',
      title: 'a share is from 0 to 1; an exposure may be greater, but not 0',
    },
  },
  {
    name: 'a resource is freed with its first user',
    file: 'src/element/decoders.ts',
    find: '--entry.users > 0',
    replace: '--entry.users > 1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/element/SharedResources.test.ts',
      title: 'a resource is made once for all its users, and freed when the last one gives it back',
    },
  },
  {
    name: 'extensions of a binary file begin at its head',
    file: 'src/element/readExtensions.ts',
    find: 'view.getUint32(HEADER - 8, true)',
    replace: 'view.getUint32(HEADER - 12, true)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/element/readExtensions.test.ts',
      title: 'the extensions of a file are read, in both forms of glTF',
    },
  },
];
