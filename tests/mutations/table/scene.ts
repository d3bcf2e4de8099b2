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
    file: 'src/scene/Replacement.ts',
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
  {
    name: 'a call does not end the earlier one for its root',
    file: 'src/scene/beginCall.ts',
    find: '  underWay.get(identityOf(root))?.giveWay();\n  const meshes',
    replace: '  const meshes',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'of two for one root the later wins; the earlier ends with an AbortError that needs no handler',
    },
  },
  {
    name: 'an update forgets the preset that is under way',
    file: 'src/scene/HatchedScene.ts',
    find: 'return this.change(this.wanted, task);',
    replace: 'return this.change(null, task);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'hatches what was added, too, and an update under way does not lose it',
    },
  },
  {
    name: 'released geometries stay on the graphics card',
    file: 'src/scene/HatchedScene.ts',
    find: '        geometry.dispose();\n        geometries.delete(geometry);',
    replace: '        geometries.delete(geometry);',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'gives a part back and frees it; nothing is left after a hundred swaps',
    },
  },
  {
    name: 'a part that is released meanwhile is shown all the same',
    file: 'src/scene/HatchedScene.ts',
    find: 'filter(({ mesh }) => !this.released.has(identityOf(mesh)))',
    replace: 'filter(() => true)',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'counts for a call under way, too',
    },
  },
  {
    name: 'edits that are made meanwhile are lost',
    file: 'src/scene/StyleChange.ts',
    find: '      // Edits may have been made since.\n      next.takeEdits(old, this.passed);\n',
    replace: '',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'keeps what was changed on materials, sources and outlines, also meanwhile',
    },
  },
  {
    name: 'detached parts keep their look',
    file: 'src/scene/HatchedScene.ts',
    find: 'isNew && !isBelow(mesh, this.root)',
    replace: 'false && isNew',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'reaches parts that are detached at the time, with their changes',
    },
  },
  {
    name: 'a source that was made invisible stays so',
    file: 'src/scene/Replacement.ts',
    find: '        this.follow();\n        return visible;',
    replace: '        if (visible) this.follow();\n        return visible;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'stay the truth: what is changed in them counts when a frame is drawn',
    },
  },
  {
    name: 'all outlines share a material',
    file: 'src/scene/OutlineMaker.ts',
    find: 'let look = this.looks.get(surface);',
    replace: 'let look = this.looks.values().next().value;',
    caughtBy: {
      layer: 'unit',
      file: 'tests/unit/scene/HatchedScene.test.ts',
      title: 'fading all materials of a part fades that part alone',
    },
  },
];
