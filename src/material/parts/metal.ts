import metal from '../../../shaders/chunks/metal.glsl?raw';
import { METAL_CONSTANTS } from '../../look/constants/metalConstants.js';
import { ROUGH } from '../../look/mirrors.js';
import { definesOf } from '../shaders/shaderText.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/** Smooth metal, beside the part of any technique: the room that it mirrors takes the place of some of its shading. */
export const part: MaterialPart = {
  surface,
  files: { './chunks/darkenedByColor.glsl': `${definesOf({ ...METAL_CONSTANTS, ROUGH })}\n${metal}` },
};
