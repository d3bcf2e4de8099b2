import type { Mutation } from '../Mutation.js';

export const occlusion: readonly Mutation[] = [
  {
    name: 'the corners of a wide ground share the view of the bulk',
    file: 'src/occlusion/chooseViews.ts',
    find: 'FARTHER = 1.5',
    replace: 'FARTHER = 1500',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/occlusion/occlusion.test.ts',
      title: 'a wide ground does not blur what stands on it',
    },
  },
  {
    name: 'samples at a border lie in the wall',
    file: 'src/occlusion/startOcclusion.ts',
    find: ' + INWARD * inward[i]',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/occlusion/occlusion.test.ts',
      title: 'turned inside out show their backs',
    },
  },
  {
    name: 'mirrored meshes are dark outside',
    file: 'src/occlusion/worldSpace.ts',
    find: 'sign * Math.sign(',
    replace: 'Math.sign(',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/occlusion/occlusion.test.ts',
      title: 'turned inside out show their backs',
    },
  },
];
