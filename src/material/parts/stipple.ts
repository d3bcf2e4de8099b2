import { SCREEN_CONSTANTS, STIPPLE_CONSTANTS } from '../../look/constants/patternConstants.js';
import { definesOf } from '../shaders/shaderText.js';
import { STIPPLE_MAP_SIZE } from '../tam/patternSizes.js';
import { stippleMap } from '../tam/stippleMap.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/** The technique `stipple`. */
export const part: MaterialPart = {
  surface,
  files: {
    ...import.meta.glob<string>(['./techniques/strokes/{stipple,dots}.glsl', './perFragment/screenGradient.glsl'], {
      base: '../../../shaders',
      query: '?raw',
      import: 'default',
      eager: true,
    }),
    './techniques/strokes/constants.glsl': [
      definesOf({ ...STIPPLE_CONSTANTS, ...SCREEN_CONSTANTS }),
      definesOf({ STIPPLE_MAP_SIZE }, ''),
    ].join('\n'),
  },
  writeUniforms(uniforms) {
    uniforms.stippleMap.value = stippleMap();
  },
};
