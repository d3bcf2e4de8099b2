import {
  FADING_CONSTANTS,
  SHADOW_CONSTANTS,
  SHADOW_SAMPLES,
  TONE_CONSTANTS,
} from '../../look/constants/shadingConstants.js';
import { constantCase, type HatchingProperty } from '../../look/HatchingProperty.js';
import { HATCHING_PROPERTIES } from '../../look/hatchingProperties.js';
import { cornerLayout } from '../../mesh/bake/attributeLayouts.js';
import { OCCLUSION_LEVELS } from '../../mesh/occlusion/occlusionSides.js';
import { VERTEX_LAYOUTS } from '../deformation/canDeform.js';
import { lightCountDefines } from '../three/lightKinds.js';
import { TONE_CURVE_TEXELS } from '../toneCurveTable.js';
import { channelDefine, SHADOWS_ALONE, TONE_CURVES } from './defineNames.js';
import { definesOf } from './shaderText.js';

const numbered = (prefix: string, names: readonly string[]) =>
  names.map((name, index) => `#define ${prefix}_${constantCase(name)} ${index}`);

/** The names that TypeScript and GLSL share, as defines; the material's own defines select among them. */
export const conventionsChunk = (): string =>
  [
    ...Object.values<HatchingProperty>(HATCHING_PROPERTIES).flatMap((property) =>
      property.kind === 'choice' ? numbered(property.define, property.choices) : [],
    ),
    ...numbered('TONE_CURVE', TONE_CURVES),
    `#define TONE_MODEL_SHADOW ${SHADOWS_ALONE}`,
    ...numbered('VERTEX_LAYOUT', VERTEX_LAYOUTS),
    definesOf({ ...TONE_CONSTANTS, ...SHADOW_CONSTANTS, ...FADING_CONSTANTS, ...OCCLUSION_LEVELS, TONE_CURVE_TEXELS }),
    definesOf({ ...SHADOW_SAMPLES }, ''),
    lightCountDefines(),
  ].join('\n');

/**
 * Macros that replace the names by which three's chunks read a map's texture coordinates: the varying of its channel, times its
 * transform.
 */
export const mapTransformsChunk = (): string =>
  Object.values<HatchingProperty>(HATCHING_PROPERTIES)
    .filter((property) => property.kind === 'texture')
    .map((texture) => {
      const { uniform, transform } = texture;
      const coordinates = `v${uniform[0].toUpperCase()}${uniform.slice(1)}Uv`;
      return `uniform mat3 ${transform};\n#define ${coordinates} (${transform} * vec3(${channelDefine(texture)}, 1.0)).xy`;
    })
    .join('\n');

/** Declarations of the attributes of the `corner` layout. */
export const cornerAttributesChunk = (): string =>
  cornerLayout.map(({ name, itemSize }) => `attribute vec${itemSize} ${name};`).join('\n');
