import { LensCamera } from './LensCamera.js';

/** Default direction from the model to the eye: a three-quarter view, a little from above. */
export const DEFAULT_VIEW = [0.62, 0.36, 1] as const;

/** The page's and the command's camera, for models with a radius of 1. The caller sets its aspect. */
export const createCamera = (): LensCamera => new LensCamera();
