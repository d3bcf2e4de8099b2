import { toothConstantsChunk } from '../tam/patternSizes.js';
import { toothMap } from '../tam/toothMap.js';
import type { MaterialPart } from './MaterialPart.js';

/** The medium `dry`. */
export const part: MaterialPart = {
  files: {
    ...import.meta.glob<string>('./chunks/{dryMedium,tooth}.glsl', {
      base: '../../../shaders',
      query: '?raw',
      import: 'default',
      eager: true,
    }),
    './chunks/toothConstants.glsl': toothConstantsChunk(),
  },
  writeUniforms(uniforms) {
    uniforms.toothMap.value = toothMap();
  },
};
