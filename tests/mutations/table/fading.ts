import type { Mutation } from '../Mutation.js';

export const fading: readonly Mutation[] = [
  {
    name: 'the vignette lies aside',
    file: 'shaders/chunks/fading.glsl',
    find: '2.0 * (pixel - sheet.xy) / sheet.zw - 1.0',
    replace: '(pixel - sheet.xy) / sheet.zw',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title:
        'hatching equals the double-precision reference: …falling off around a point, towards the rim and of less importance',
    },
  },
  {
    name: 'air lies before what is near',
    file: 'shaders/chunks/fading.glsl',
    find: '(-viewPosition.z - depthFading.x)',
    replace: '(-viewPosition.z - depthFading.y)',
    caughtBy: {
      layer: 'gpu',
      file: 'tests/gpu/anchored.spec.ts',
      title: 'hatching equals the double-precision reference: …fading with its depth',
    },
  },
];
