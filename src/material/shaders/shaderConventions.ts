import { ShaderChunk } from 'three';
import {
  EMPHASIS_CONSTANTS,
  SHADOW_CONSTANTS,
  SHADOW_SAMPLES,
  TONE_CONSTANTS,
} from '../../look/constants/shadingConstants.js';
import { constantCase, type HatchingProperty, type HatchingTexture } from '../../look/HatchingProperty.js';
import { HATCHING_PROPERTIES } from '../../look/hatchingProperties.js';
import { cornerLayout } from '../../mesh/bake/attributeLayouts.js';
import { definesOf } from './definesOf.js';
import { lightCountDefines } from './lightKinds.js';

export const TONE_CURVES = ['linear', 'perceptual', 'points'] as const;
/** The most spans that a tone curve given by points can have: one less than points. */
export const TONE_CURVE_SPANS = 7;

export const VERTEX_LAYOUTS = ['corner', 'pull', 'deforming'] as const;
/** Where a vertex finds its adjacency primitive: in its attributes, in textures, or in textures that a pre-pass writes. */
export type VertexLayout = (typeof VERTEX_LAYOUTS)[number];

const numbered = (prefix: string, names: readonly string[]) =>
  names.map((name, index) => `#define ${prefix}_${constantCase(name)} ${index}`);

/** The names that TypeScript and GLSL share, as defines. The one that is chosen is a define of the material. */
export const conventionsChunk = (): string =>
  [
    ...Object.values<HatchingProperty>(HATCHING_PROPERTIES).flatMap((property) =>
      property.kind === 'choice' && property.define ? numbered(property.define, property.choices) : [],
    ),
    ...numbered('TONE_CURVE', TONE_CURVES),
    ...numbered('VERTEX_LAYOUT', VERTEX_LAYOUTS),
    definesOf({ ...TONE_CONSTANTS, ...SHADOW_CONSTANTS, ...EMPHASIS_CONSTANTS }),
    definesOf({ TONE_CURVE_SPANS, ...SHADOW_SAMPLES }, ''),
    lightCountDefines(),
  ].join('\n');

/** The define that names the varying of a map's coordinates. It is not defined where there is no map. */
export const channelDefine = ({ uniform }: HatchingTexture): string => `${uniform.toUpperCase()}_CHANNEL`;

/** The varyings that hold the coordinates of each channel. */
export const CHANNEL_VARYINGS = ['vUv', 'vUv1', 'vUv2', 'vUv3'] as const;

/** Macros for the names by which three's chunks ask for a map's coordinates: those of its channel, times its transform. */
export const mapTransformsChunk = (): string =>
  Object.values<HatchingProperty>(HATCHING_PROPERTIES)
    .filter((property) => property.kind === 'texture')
    .map((texture) => {
      const { uniform, transform } = texture;
      const coordinates = `v${uniform[0].toUpperCase()}${uniform.slice(1)}Uv`;
      return `uniform mat3 ${transform};\n#define ${coordinates} (${transform} * vec3(${channelDefine(texture)}, 1.0)).xy`;
    })
    .join('\n');

/** three's chunk by which shadows of older versions unpack depth. A later version may no longer have it. */
export const packingChunk = (): string => ('packing' in ShaderChunk ? '#include <packing>' : '');

/** Declarations of the attributes of the `corner` layout. */
export const cornerAttributesChunk = (): string =>
  cornerLayout.map(({ name, itemSize }) => `attribute vec${itemSize} ${name};`).join('\n');
