import { DataTexture, LinearFilter, NoColorSpace, RGFormat, UnsignedByteType } from 'three';
import { packThresholds } from './packThresholds.js';
import type { ThresholdPair } from './pairThresholdLevels.js';

/**
 * The texture of a threshold map: 0 stands for g = −3 and 1 for g = 3. Red holds a level, green the next coarser level at the same
 * place. All levels lie side by side (see {@link packThresholds}).
 */
export class ThresholdTexture extends DataTexture {
  /** @internal */
  constructor(pairs: readonly ThresholdPair[]) {
    const { data, width, height } = packThresholds(pairs);
    super(data, width, height, RGFormat, UnsignedByteType);
    this.name = 'Thresholds';
    this.colorSpace = NoColorSpace;
    this.magFilter = LinearFilter;
    this.minFilter = LinearFilter;
    this.generateMipmaps = false;
    // The length of a row in bytes is even, but need not be a multiple of four.
    this.unpackAlignment = 2;
    this.needsUpdate = true;
  }
}
