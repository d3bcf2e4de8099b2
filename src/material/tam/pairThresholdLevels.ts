import type { ThresholdLevel } from '../../strokes/tamImages/thresholds.js';

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
