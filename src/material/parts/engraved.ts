import { writeFieldFrame } from './fieldFrame.js';
import type { MaterialPart } from './MaterialPart.js';

/** The technique `engraved`. */
export const part: MaterialPart = {
  files: import.meta.glob(
    ['./techniques/engraved/*', './chunks/lineCoverage.glsl', './perFragment/screenGradient.glsl'],
    { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
  ),
  bindMesh(_renderer, _camera, geometry, object, material) {
    if (writeFieldFrame(material.uniforms, material.tilesPerUnit, geometry, object)) material.uniformsNeedUpdate = true;
    return undefined;
  },
};
