import { PerspectiveCamera } from 'three';

/** The lens of both pages: its vertical field of view in degrees, and what it sees. */
export const LENS = { fieldOfView: 26, near: 0.05, far: 100 } as const;

/** Direction from the model to the eye unless a model sets another: a three-quarter view, a little from above. */
export const DEFAULT_VIEW = [0.62, 0.36, 1] as const;

/** The camera of both pages, for models with a radius of 1. Its aspect has still to be set. */
export function createCamera(): PerspectiveCamera {
  return new PerspectiveCamera(LENS.fieldOfView, 1, LENS.near, LENS.far);
}
