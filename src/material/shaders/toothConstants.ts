import { TOOTH_MAP_BUMP, TOOTH_MAP_SIZE } from '../tam/patternSizes.js';
import { definesOf } from './definesOf.js';

/** What shaders know of the map of a paper's tooth. */
export const toothConstantsChunk = (): string => definesOf({ TOOTH_MAP_SIZE, TOOTH_MAP_BUMP });
