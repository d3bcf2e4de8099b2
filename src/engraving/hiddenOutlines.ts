/** Outlines behind a surface that are drawn all the same, as shaders/outlines/hidden.glsl has them. */
import { smoothstep } from './vectors.js';

/** How they are drawn. */
export const HIDDEN_OUTLINES = ['none', 'dashed', 'faint'] as const;
export type HiddenOutlines = (typeof HIDDEN_OUTLINES)[number];

/** The weight of what is hidden, whatever it would weigh where it is seen; what weighs less than the second there is hidden in part. */
const HIDDEN_WEIGHT = 0.5;
const WHOLE_FROM = 0.2;
/** The share of the ink that is left of faint lines. */
export const FAINT = 0.4;
/** Lengths of a dash and of the gap after it, in widths of an outline. */
export const DASH = 3.5;
export const GAP = 2;

export const hiddenWeight = (weight: number): number => HIDDEN_WEIGHT * smoothstep(0, WHOLE_FROM, weight);
