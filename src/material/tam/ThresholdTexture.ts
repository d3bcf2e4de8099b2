import { DataTexture, LinearFilter, NoColorSpace, RGFormat, UnsignedByteType } from 'three';
import type { ThresholdPair } from './pairThresholdLevels.js';

/** The width of the margin around each level, in texels. It repeats the opposite side, so that interpolation works at the border. */
const MARGIN = 1;

/** Levels of thresholds side by side in one image of two bytes per texel. */
interface PackedThresholds {
  width: number;
  height: number;
  /** Rows of growing v. Each texel has the byte of its level, then that of the next coarser level. */
  data: Uint8Array;
}

/**
 * Packs levels into one image, side by side along the lower edge, finest first. Level l begins 2·size·(1 − 2⁻ˡ) + 2l texels from the
 * left, where `size` is that of level 0, and has a margin of one texel all round. There are no mip levels: a shader that knows the
 * level reads it with a plain fetch, while `textureLod` is slow.
 */
export function packThresholds(pairs: readonly ThresholdPair[]): PackedThresholds {
  const width = pairs.reduce((sum, { size }) => sum + size + 2 * MARGIN, 0);
  const height = pairs[0].size + 2 * MARGIN;
  const data = new Uint8Array(2 * width * height);
  let left = 0;
  for (const { size, own, coarser } of pairs) {
    const mask = size - 1;
    const side = size + 2 * MARGIN;
    for (let row = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const from = ((row - MARGIN) & mask) * size + ((column - MARGIN) & mask);
        const to = 2 * (row * width + left + column);
        data[to] = own[from];
        data[to + 1] = coarser[from];
      }
    }
    left += side;
  }
  return { width, height, data };
}

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
