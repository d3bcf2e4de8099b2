import { sceneExposure } from '../exposure/sceneExposure.js';
import type { MaterialPart } from './MaterialPart.js';

/** Fits the exposure of materials that ask for it. */
export const part: MaterialPart = { files: {}, sceneExposure };
