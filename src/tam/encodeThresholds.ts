/** Thresholds of one level in both forms. */
export interface ThresholdLevel {
  /** Texels per side. */
  size: number;
  /** size² tones in (0, 1), in rows of growing v: from which tone on the texel is ink. Uniformly distributed. */
  thresholds: Float32Array;
  /** Φ⁻¹ of them, clamped to ±3, as half floats: normally distributed. What the texture holds. */
  encoded: Uint16Array;
}

/** Beyond so many standard deviations lies 0.13 % of the texels; they become ink together. */
const LIMIT = 3;

/** Φ⁻¹(p), the quantile of the standard normal distribution, to 5e-4 (Abramowitz and Stegun 1964, 26.2.23). */
export function normalQuantile(p: number): number {
  if (p > 0.5) return -normalQuantile(1 - p);
  const t = Math.sqrt(-2 * Math.log(p));
  const numerator = 2.515517 + t * (0.802853 + t * 0.010328);
  const denominator = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
  return numerator / denominator - t;
}

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

/** The bits of the half float nearest to a number of at most 2¹⁵. */
export function toHalf(value: number): number {
  float[0] = value;
  const sign = (bits[0] >>> 16) & 0x8000;
  const magnitude = Math.abs(value);
  // Below 2⁻¹⁴ half floats are multiples of 2⁻²⁴; above, they are floats with 13 bits less of mantissa and a smaller bias.
  if (magnitude < 2 ** -14) return sign | Math.round(magnitude * 2 ** 24);
  return sign | (((bits[0] & 0x7fffffff) - 0x38000000 + 0x1000) >>> 13);
}

/** Encodes thresholds for the texture. */
export function encodeThresholds(size: number, thresholds: Float32Array): ThresholdLevel {
  const encoded = new Uint16Array(thresholds.length);
  for (let i = 0; i < thresholds.length; i++) {
    encoded[i] = toHalf(Math.max(-LIMIT, Math.min(LIMIT, normalQuantile(thresholds[i]))));
  }
  return { size, thresholds, encoded };
}
