import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RedFormat,
  RepeatWrapping,
  UnsignedByteType,
} from 'three';
import type { ThresholdLevel } from './encodeThresholds.js';

/**
 * The texture of a threshold map: one byte per texel, 0 for g = −3 and 255 for g = 3, with drawn mip levels. Averaged levels would have less
 * variance, so less contrast of tone, and thinner strokes.
 */
export class ThresholdTexture extends DataTexture {
  constructor(levels: readonly ThresholdLevel[]) {
    super(levels[0].encoded, levels[0].size, levels[0].size, RedFormat, UnsignedByteType);
    this.name = 'Thresholds';
    this.mipmaps = levels.map(({ encoded, size }) => ({ data: encoded, width: size, height: size }));
    this.colorSpace = NoColorSpace;
    this.wrapS = RepeatWrapping;
    this.wrapT = RepeatWrapping;
    this.magFilter = LinearFilter;
    this.minFilter = levels.length > 1 ? LinearMipmapLinearFilter : LinearFilter;
    this.generateMipmaps = false;
    this.needsUpdate = true;
  }
}
