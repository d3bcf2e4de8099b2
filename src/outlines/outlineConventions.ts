import { POINT_BITS, POINT_MASK } from '../bake/outlineLayout.js';
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../engraving/outlineConstants.js';
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  IS_EDGE,
  MATERIAL_BORDER,
} from '../features/edgeFlags.js';

const flags = { BORDER, CREASE, MATERIAL_BORDER, CONTRARY, CORNER_AT_START, CORNER_AT_END, IS_EDGE };

/** A number as GLSL writes a float. */
const asFloat = (value: number): string => (Number.isInteger(value) ? `${value}.0` : String(value));

/** The constants that the bake, the drawing as lines and the shaders of outlines share, as defines. */
export const outlineConventionsChunk = (): string =>
  [
    ...Object.entries(flags).map(([name, bit]) => `#define EDGE_${name} ${bit}u`),
    ...Object.entries(OUTLINE_CONSTANTS).map(([name, value]) => `#define ${name} ${asFloat(value)}`),
    `#define ACCENT_STEPS ${ACCENT_STEPS}`,
    `#define POINT_BITS ${POINT_BITS}`,
    `#define POINT_MASK ${POINT_MASK}u`,
  ].join('\n');
