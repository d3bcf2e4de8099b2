/** Counterpart of shaders/outlines/width.glsl: the width of an outline at an end of a piece. */
import { tsl, type Value } from '../base/values.js';
import { hiddenWeight } from './hidden.js';
import { outlineWidth } from './hierarchy.js';
import type { OutlineDefines } from './OutlineDefines.js';
import type { PieceEnd } from './piece.js';

const { max, vec2 } = tsl;

/** Half widths before paper and before a surface, pixels, without the factor of fading. */
export const halfWidthsAt = ({ weight, innerWeight }: PieceEnd, { HIDDEN }: OutlineDefines): Value =>
  (HIDDEN ? vec2(hiddenWeight(max(weight, innerWeight))) : vec2(weight, innerWeight)).mul(outlineWidth).mul(0.5);
