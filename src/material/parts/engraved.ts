import { hasOtherFormAngle, noteFormAngle } from '../geometry/formAngles.js';
import { lineContrast } from '../geometry/lineFades.js';
import { followsForm } from '../../look/lookFacts.js';
import { engravedConstantsChunk } from './engravedConstants.js';
import { writeFieldFrame } from './fieldFrame.js';
import type { MaterialPart } from './MaterialPart.js';

/** The technique `engraved`. */
export const part: MaterialPart = {
  files: {
    ...import.meta.glob<string>(
      ['./techniques/engraved/*', './chunks/lineCoverage.glsl', './perFragment/screenGradient.glsl'],
      { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
    ),
    './techniques/engraved/constants.glsl': engravedConstantsChunk(),
  },
  bindMesh(renderer, _camera, geometry, object, material) {
    const { uniforms } = material;
    const contrast = lineContrast(geometry);
    const isOther = contrast !== uniforms.lineContrast.value;
    if (isOther) uniforms.lineContrast.value = contrast;
    if (writeFieldFrame(uniforms, material.tilesPerUnit, geometry, object) || isOther) material.ofMesh.want(renderer);
    if (hasOtherFormAngle(geometry, material) && followsForm(material)) noteFormAngle(geometry, material);
    return undefined;
  },
};
