import type { HatchingTexture } from '../../look/HatchingProperty.js';
import { HATCHING_PROPERTIES } from '../../look/hatchingProperties.js';

/** The kinds of tone curves, which shaders know by their number. */
export const TONE_CURVES = ['linear', 'perceptual', 'points'] as const;

/** The number of the tone model of `HatchingShadowMaterial`, which follows those that may be chosen. */
export const SHADOWS_ALONE = HATCHING_PROPERTIES.toneModel.choices.length;

/** The define that names the varying of a map's texture coordinates. It is not defined without the map. */
export const channelDefine = ({ uniform }: HatchingTexture): string => `${uniform.toUpperCase()}_CHANNEL`;

/** The varyings of the texture coordinates of each channel. */
export const CHANNEL_VARYINGS = ['vUv', 'vUv1', 'vUv2', 'vUv3'] as const;
