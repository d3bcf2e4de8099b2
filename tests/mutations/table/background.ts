import type { Mutation } from '../Mutation.js';

export const background: readonly Mutation[] = [
  {
    name: 'a background has its light on the wrong side',
    file: 'shaders/background/background.frag',
    find: '1.0 + contrast * side',
    replace: '1.0 - contrast * side',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/background.spec.ts',
      title: 'a background is darker behind the lit side',
    },
  },
  {
    name: 'lines of a background have no room',
    file: 'shaders/background/background.frag',
    find: 'abs(across - line - 0.5) * spacing',
    replace: 'abs(across - line) * spacing',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/background.spec.ts',
      title: 'a background has the tone that is asked for',
    },
  },
  {
    name: 'both ends of a line of a background are as ragged',
    file: 'shaders/background/background.frag',
    find: 'hash01(line, step(0.0, along))',
    replace: 'hash01(line, 0.0)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/background.spec.ts',
      title: 'every pixel of a background is that of the lines of vector files',
    },
  },
];
