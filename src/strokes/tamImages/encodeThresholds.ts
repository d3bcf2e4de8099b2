/** The thresholds of one level, as numbers and encoded. */
export interface ThresholdLevel {
  /** Texels per side. */
  size: number;
  /** size² numbers in (0, 1), in rows of growing v: the tones at which the texels become ink. They are uniformly distributed. */
  thresholds: Float32Array;
  /** g = Φ⁻¹(threshold) as bytes, 0 for −3 and 255 for 3: normally distributed. The content of the texture. */
  encoded: Uint8Array;
}

/** g is clamped at this many standard deviations. The 0.13 % of the texels beyond become ink all at once. */
export const LIMIT = 3;

/** Φ⁻¹(p), the quantile of the standard normal distribution, to 5e-4 (Abramowitz and Stegun 1964, 26.2.23). */
export function normalQuantile(p: number): number {
  if (p > 0.5) return -normalQuantile(1 - p);
  const t = Math.sqrt(-2 * Math.log(p));
  const numerator = 2.515517 + t * (0.802853 + t * 0.010328);
  const denominator = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
  return numerator / denominator - t;
}

/**
 * Encodes thresholds for the texture. Bytes are precise enough, because edges lie between texels, where the texture unit
 * interpolates. Half floats would take a software rasterizer a third of the frame time.
 */
export function encodeThresholds(size: number, thresholds: Float32Array): ThresholdLevel {
  const encoded = new Uint8Array(thresholds.length);
  for (let i = 0; i < thresholds.length; i++) {
    const g = Math.max(-LIMIT, Math.min(LIMIT, normalQuantile(thresholds[i])));
    // Rounding away from the middle keeps a threshold and its complement symmetric.
    encoded[i] = g < 0 ? Math.ceil(127.5 * (1 + g / LIMIT) - 0.5) : Math.floor(127.5 * (1 + g / LIMIT) + 0.5);
  }
  return { size, thresholds, encoded };
}
