import type { ModelScene } from '../files/parseGltf.js';

/** A model that was made here with parts that move, instead of read. */
export interface BuiltInScene {
  kind: 'scene';
  name: string;
  upAxis: 'y';
  scene: ModelScene;
}
