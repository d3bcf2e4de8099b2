import { POINT_BITS, POINT_MASK } from '../bake/outlineLayout.js';
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

/** The constants that the bake and the shaders of outlines share, as defines. */
export const outlineConventionsChunk = (): string =>
  [
    ...Object.entries(flags).map(([name, bit]) => `#define EDGE_${name} ${bit}u`),
    `#define POINT_BITS ${POINT_BITS}`,
    `#define POINT_MASK ${POINT_MASK}u`,
  ].join('\n');
