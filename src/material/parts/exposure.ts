import { sceneExposure } from '../exposure/sceneExposure.js';
import type { MaterialPart } from './MaterialPart.js';

/** The part that fits exposures, for materials with an `exposure` of `'auto'`. */
export const part: MaterialPart = { files: {}, sceneExposure };
