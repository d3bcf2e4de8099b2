import type { Object3D, Scene, Texture } from 'three';
import { lightsAlready } from './blurredEnvironment.js';

/** The environment of the scene that contains an object; null if there is none or it is still loading. */
export function environmentAround(object: Object3D): Texture | null {
  let root = object;
  while (root.parent) root = root.parent;
  const { environment } = root as Scene;
  return environment && lightsAlready(environment) ? environment : null;
}
