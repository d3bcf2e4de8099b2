import { DataTexture, LinearFilter, NoColorSpace, RGFormat, UnsignedByteType } from 'three';
import { LIMIT, type ThresholdLevel } from '../../strokes/tamImages/thresholds.js';

/** A level of thresholds and the next coarser level at the same resolution, both encoded as in {@link ThresholdLevel}. */
export interface ThresholdPair {
  /** Texels per side. */
  size: number;
  own: Uint8Array;
  /** The next coarser level. The coarsest level is paired with itself. */
  coarser: Uint8Array;
}

/**
 * Pairs each level with the next coarser one, interpolated to the same resolution, so that one fetch reads both. A stroke size between
 * two levels then takes no more fetches than that of a single level.
 *
 * @param levels the finest first; each has half the texels per side of the previous level
 */
export function pairThresholdLevels(levels: readonly ThresholdLevel[]): ThresholdPair[] {
  return levels.map(({ size, encoded }, index) => {
    const next = levels[index + 1];
    return { size, own: encoded, coarser: next ? enlarge(next) : encoded };
  });
}

/** Doubles the texels per side by bilinear interpolation with wrap-around: new texel centres lie at 1/4 and 3/4 between old ones. */
function enlarge({ size, encoded }: ThresholdLevel): Uint8Array {
  const mask = size - 1;
  const enlarged = new Uint8Array(4 * encoded.length);
  for (let row = 0; row < 2 * size; row++) {
    const near = (row >> 1) * size;
    const far = (((row >> 1) + (row & 1 ? 1 : -1)) & mask) * size;
    for (let column = 0; column < 2 * size; column++) {
      const beside = column >> 1;
      const beyond = (beside + (column & 1 ? 1 : -1)) & mask;
      const sum =
        9 * encoded[near + beside] + 3 * (encoded[near + beyond] + encoded[far + beside]) + encoded[far + beyond];
      // Halves are rounded away from the middle, as in encoding, which keeps symmetric texels symmetric.
      enlarged[2 * row * size + column] = sum < 2040 ? Math.ceil(sum / 16 - 0.5) : Math.floor(sum / 16 + 0.5);
    }
  }
  return enlarged;
}

/** The contrast of a threshold map after interpolation, averaged over its levels. */
export interface ThresholdMoments {
  /** The variance of g after a texture unit has interpolated it between texels; 1 at the texels themselves. */
  variance: number;
  /** The same variance for the next coarser level, at the resolution of the finer one; 0 if there is only one level. */
  coarserVariance: number;
  /** The covariance of a level and the next coarser one, a measure of how well their strokes nest; 0 if there is only one level. */
  covariance: number;
}

const SAMPLES = 8192;

/**
 * Measures the moments at the points of Roberts' R2 sequence, which cover the tile evenly and are always the same.
 */
export function measureThresholdMoments(pairs: readonly ThresholdPair[]): ThresholdMoments {
  let squares = 0;
  let coarserSquares = 0;
  let products = 0;
  let [u, v] = [0.5, 0.5];
  for (let i = 0; i < SAMPLES; i++) {
    u = (u + 0.7548776662466927) % 1;
    v = (v + 0.5698402909980532) % 1;
    pairs.forEach(({ size, own, coarser }, index) => {
      const g = interpolate(own, size, u, v);
      squares += g * g;
      if (index === pairs.length - 1) return;
      const next = interpolate(coarser, size, u, v);
      coarserSquares += next * next;
      products += g * next;
    });
  }
  const steps = SAMPLES * Math.max(pairs.length - 1, 1);
  return {
    variance: squares / (SAMPLES * pairs.length),
    coarserVariance: coarserSquares / steps,
    covariance: products / steps,
  };
}

/** g by bilinear interpolation at (u, v) in tiles, texel centres at half texels, as a texture unit does it. */
function interpolate(encoded: Uint8Array, size: number, u: number, v: number): number {
  const x = u * size - 0.5 + size;
  const y = v * size - 0.5 + size;
  const column = Math.floor(x);
  const row = Math.floor(y);
  const right = x - column;
  const down = y - row;
  const mask = size - 1;
  const at = (i: number, j: number) => encoded[((row + j) & mask) * size + ((column + i) & mask)];
  const upper = at(0, 0) * (1 - right) + at(1, 0) * right;
  const lower = at(0, 1) * (1 - right) + at(1, 1) * right;
  return LIMIT * ((upper * (1 - down) + lower * down) / 127.5 - 1);
}

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
