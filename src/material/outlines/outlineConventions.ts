import { POINT_BITS, POINT_MASK } from '../../mesh/bake/outlineLayout.js';
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  IS_EDGE,
  MATERIAL_BORDER,
} from '../../mesh/features/edgeFlags.js';
import { definesOf } from '../shaders/definesOf.js';

const flags = { BORDER, CREASE, MATERIAL_BORDER, CONTRARY, CORNER_AT_START, CORNER_AT_END, IS_EDGE };

/** The constants that the bake, the drawing as lines and the shaders of outlines share, as defines. */
export const outlineConventionsChunk = (): string =>
  [
    ...Object.entries(flags).map(([name, bit]) => `#define EDGE_${name} ${bit}u`),
    definesOf(OUTLINE_CONSTANTS),
    definesOf({ ACCENT_STEPS, POINT_BITS }, ''),
    definesOf({ POINT_MASK }, 'u'),
  ].join('\n');
