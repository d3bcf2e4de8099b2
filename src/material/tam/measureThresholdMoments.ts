import { LIMIT } from '../../strokes/tamImages/thresholds.js';
import type { ThresholdPair } from './pairThresholdLevels.js';

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
