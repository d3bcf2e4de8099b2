import type { LiveScene } from '../files/parseGltf.js';

/** A model that was made here with parts that move, instead of read. */
export interface MadeScene {
  kind: 'scene';
  name: string;
  upAxis: 'y';
  scene: LiveScene;
}
