import type { Mutation } from '../Mutation.js';

export const archives: readonly Mutation[] = [
  {
    name: 'a later version of a drawing is called damaged',
    file: 'src/viewer/files/bundle.ts',
    find: 'version > VERSION',
    replace: 'version > VERSION + 1',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/bundle.test.ts',
      title: 'rejects a damaged or hostile one with one sentence',
    },
  },
  {
    name: 'hidden files of a drawing are unpacked',
    file: 'src/viewer/files/bundle.ts',
    find: "if (baseName(path).startsWith('.')) return false;",
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/bundle.test.ts',
      title: 'nor does it matter if another program has packed it, with its folder, or what the model is called',
    },
  },
  {
    name: 'gzip unpacks without a limit',
    file: 'src/viewer/files/readArchive.ts',
    find: 'length > limit',
    replace: 'length < 0',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/gunzip.test.ts',
      title: 'a small archive may unpack to 64 megabytes, and not to more',
    },
  },
  {
    name: 'an archive may announce less than it holds',
    file: 'src/viewer/files/readArchive.ts',
    find: 'Math.max(packedSize, originalSize)',
    replace: 'Math.min(packedSize, originalSize)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/viewer/files/scenes/readScene.test.ts',
      title: 'decompression bombs are not unpacked',
    },
  },
];
