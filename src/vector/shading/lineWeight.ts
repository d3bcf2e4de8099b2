/** The line weight of an outline, as in shaders/outlines/hierarchy.glsl: the share of paper in what lies behind it, and of an accent. */
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { smoothstep } from '../../look/vectors.js';
import { paperness } from './outlines.js';

const { ACCENT_REACH, LEAST_JUMP, FULL_JUMP } = OUTLINE_CONSTANTS;

/** Distance between steps, in the unit of the width. */
export const strideOf = (outlineWidth: number): number => (ACCENT_REACH * outlineWidth) / ACCENT_STEPS;

export interface LineWeight {
  /** The share of paper in what lies behind. */
  paper: number;
  /** 1 where another outline begins, 0 where none is near. */
  accent: number;
}

/**
 * The line weight at a place. Along the outline the weight changes gradually with what lies behind it, and an accent grows towards such a
 * change.
 *
 * @param here distance from the outline back to the surface beside it, in heights of the view, up to 1
 * @param gapAt the same distance at a step along the outline, in either direction; undefined beyond the picture
 */
export function lineWeightAt(here: number, gapAt: (step: number) => number | undefined): LineWeight {
  let paper = paperness(here);
  let sum = 1;
  let accent = 0;
  for (const side of [-1, 1]) {
    let last = here;
    for (let i = 1; i <= ACCENT_STEPS; i++) {
      const gap = gapAt(side * i);
      if (gap === undefined || Math.min(gap, last) < LEAST_JUMP) break;
      const nearness = 1 - (i - 0.5) / ACCENT_STEPS;
      accent = Math.max(accent, nearness * smoothstep(LEAST_JUMP, FULL_JUMP, Math.abs(gap - last)));
      paper += nearness * paperness(gap);
      sum += nearness;
      last = gap;
    }
  }
  return { paper: paper / sum, accent };
}
