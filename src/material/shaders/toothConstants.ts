import { TOOTH_MAP_BUMP, TOOTH_MAP_SIZE } from '../tam/patternSizes.js';
import { definesOf } from './definesOf.js';

/** The constants of the tooth map, as defines. */
export const toothConstantsChunk = (): string => definesOf({ TOOTH_MAP_SIZE, TOOTH_MAP_BUMP });
