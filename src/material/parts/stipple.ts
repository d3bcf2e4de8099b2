import { stippleMap } from '../../tam/stippleMap.js';
import type { MaterialPart } from './MaterialPart.js';

/** The medium `stipple`. */
export const part: MaterialPart = {
  files: import.meta.glob(['./techniques/anchored/{stipple,dots}.glsl', './perFragment/screenGradient.glsl'], {
    base: '../../../shaders',
    query: '?raw',
    import: 'default',
    eager: true,
  }),
  writeUniforms(uniforms) {
    uniforms.stippleMap.value = stippleMap();
  },
};
