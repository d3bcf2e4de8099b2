import { LensCamera } from './LensCamera.js';

/** Direction from the model to the eye unless a model sets another: a three-quarter view, a little from above. */
export const DEFAULT_VIEW = [0.62, 0.36, 1] as const;

/** The camera of both pages, for models with a radius of 1. Its aspect has still to be set. */
export const createCamera = (): LensCamera => new LensCamera();
