/** Outlines that are drawn behind surfaces, as in shaders/outlines/hidden.glsl. */
import { OUTLINE_CONSTANTS } from './constants/outlineConstants.js';
import { smoothstep } from './vectors.js';

const { HIDDEN_WEIGHT, WHOLE_FROM } = OUTLINE_CONSTANTS;

/** The ways to draw them. */
export const HIDDEN_OUTLINES = ['none', 'dashed', 'faint'] as const;
export type HiddenOutlines = (typeof HIDDEN_OUTLINES)[number];

export const hiddenWeight = (weight: number): number => HIDDEN_WEIGHT * smoothstep(0, WHOLE_FROM, weight);
