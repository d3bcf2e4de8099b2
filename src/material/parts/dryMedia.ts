import { toothConstantsChunk } from '../tam/patternSizes.js';
import { toothMap } from '../tam/toothMap.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/** The technique `dryMedia`. */
export const part: MaterialPart = {
  surface,
  files: {
    ...import.meta.glob<string>('./chunks/{dryMedia,tooth}.glsl', {
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
