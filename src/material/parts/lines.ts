import {
  CARVING_CONSTANTS,
  FIELD_CONSTANTS,
  FORM_CONSTANTS,
  GROUND_CONSTANTS,
  HAND_CONSTANTS,
  LINE_CONSTANTS,
  PEN_CONSTANTS,
  STROKE_LENGTH_CONSTANTS,
} from '../../look/constants/lineConstants.js';
import { HASH_FACTORS, SCREEN_CONSTANTS } from '../../look/constants/patternConstants.js';
import { followsForm } from '../../look/queries.js';
import { hasOtherFormAngle, noteFormAngle } from '../geometry/formAngles.js';
import { lineContrast } from '../geometry/lineFades.js';
import { definesOf } from '../shaders/shaderText.js';
import { writeFieldFrame } from './fieldFrame.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

const TABLES = [
  ...[LINE_CONSTANTS, SCREEN_CONSTANTS, FIELD_CONSTANTS, FORM_CONSTANTS, GROUND_CONSTANTS],
  ...[HAND_CONSTANTS, STROKE_LENGTH_CONSTANTS, PEN_CONSTANTS, CARVING_CONSTANTS],
];

/** The constants of lines, as defines; vector drawing uses them too. */
const lineConstantsChunk = (): string =>
  [...TABLES.map((table) => definesOf(table)), definesOf(HASH_FACTORS, 'u')].join('\n');

/** The techniques `engraving` and `pen`, and what they share with `woodcut`. */
export const part: MaterialPart = {
  surface,
  files: {
    ...import.meta.glob<string>(
      [
        './techniques/lines/*',
        '!./techniques/lines/carving.glsl',
        './chunks/lineCoverage.glsl',
        './perFragment/screenGradient.glsl',
      ],
      { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
    ),
    './techniques/lines/constants.glsl': lineConstantsChunk(),
  },
  bindMesh(renderer, _camera, geometry, object, material) {
    const { uniforms } = material;
    const contrast = lineContrast(geometry);
    const isOther = contrast !== uniforms.lineContrast.value;
    if (isOther) uniforms.lineContrast.value = contrast;
    if (writeFieldFrame(uniforms, material.tilesPerObjectUnit, geometry, object) || isOther)
      material.ofMesh.want(renderer);
    if (hasOtherFormAngle(geometry, material) && followsForm(material)) noteFormAngle(geometry, material);
    return undefined;
  },
};
