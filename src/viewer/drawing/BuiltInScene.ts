import type { ModelScene } from '../files/gltf/parseGltf.js';

/** A built-in model that is made by code as a scene, instead of read from a file. */
export interface BuiltInScene {
  kind: 'scene';
  name: string;
  upAxis: 'y';
  scene: ModelScene;
}
