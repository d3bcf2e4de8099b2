import { definesOf } from '../shaders/shaderText.js';

/** The sizes of the patterns of media. They are apart from the code that makes the patterns, because shaders need them too. */

/** The number of cells per side after which the points of stipple repeat: a power of two. */
export const STIPPLE_PERIOD = 32;
/** Texels per side. There are four texels per cell, since a cell has four quarters, of which one holds the cell's point. */
export const STIPPLE_MAP_SIZE = 2 * STIPPLE_PERIOD;

/** Texels per side: a power of two. */
export const TOOTH_MAP_SIZE = 256;
/** The radius of the tooth's blur, in texels. The shader relies on it: neighbouring texels have a correlation of 16/19. */
export const TOOTH_MAP_RADIUS = 2;
/** The size of a bump of the tooth, in texels, which results from the blur. */
export const TOOTH_MAP_BUMP = 2 * TOOTH_MAP_RADIUS;

/** The constants of the tooth map, as defines. */
export const toothConstantsChunk = (): string => definesOf({ TOOTH_MAP_SIZE, TOOTH_MAP_BUMP });
