import type { Mutation } from '../Mutation.js';

export const stipple: readonly Mutation[] = [
  {
    name: 'dots cover too much in the darks',
    file: 'shaders/techniques/strokes/stipple.glsl',
    find: '(1.0 - CLOSING.y) * way * way',
    replace: '2.0 * way',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/stippleDots.spec.ts',
      title: 'stipple equals the dots of vector files: …sized on the screen',
    },
  },
];
