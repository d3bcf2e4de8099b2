import type { Mutation } from '../Mutation.js';

export const scene: readonly Mutation[] = [
  {
    name: 'a wish of an object above is not heard',
    file: 'src/scene/leftAlone.ts',
    find: 'object !== null; object = object.parent',
    replace: 'object === mesh; object = object.parent',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/leftAlone.test.ts',
      title:
        'userData.hatching false leaves a mesh and its descendants alone, and true hatches them whatever the material',
    },
  },
  {
    name: 'a material of a shader is replaced',
    file: 'src/scene/leftAlone.ts',
    find: "if ('isShaderMaterial' in material)",
    replace: "if ('isRawShaderMaterial' in material)",
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/leftAlone.test.ts',
      title: 'among several materials those with their own shader stay',
    },
  },
  {
    name: 'numbers out of range become the least',
    file: 'src/scene/MaterialReplacer.ts',
    find: 'Math.min(Math.max(value as number, from), to)',
    replace: 'from',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/applyHatching.test.ts',
      title: 'dispose restores and frees every geometry and material made, once, and no other',
    },
  },
  {
    name: 'clipping planes are not taken over',
    file: 'src/scene/MaterialReplacer.ts',
    find: 'material.clippingPlanes = source.clippingPlanes;',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/applyHatching.test.ts',
      title: 'a material keeps everything that has a meaning on paper',
    },
  },
  {
    name: 'outlines of a preset keep their width in print',
    file: 'src/scene/scalePreset.ts',
    find: '{ ...outlines, ...scaledOutlineSizes(outlines, factor) }',
    replace: 'outlines',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/presets.test.ts',
      title: 'techni … grows in every size and in nothing else',
    },
  },
];
