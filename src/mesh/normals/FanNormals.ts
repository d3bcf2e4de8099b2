import type { Fans } from './buildFans.js';

/** Unit normals, one per fan: x, y, z in the order of the fans' numbers. */
export interface FanNormals {
  fans: Fans;
  normals: Float32Array<ArrayBuffer>;
}
