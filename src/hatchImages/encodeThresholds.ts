/** Thresholds of one level in both forms. */
export interface ThresholdLevel {
  /** Texels per side. */
  size: number;
  /** size² tones in (0, 1), in rows of growing v, at which texels become ink. Uniformly distributed. */
  thresholds: Float32Array;
  /** g = Φ⁻¹(threshold) as bytes, 0 for −3 and 255 for 3: normally distributed. The content of the texture. */
  encoded: Uint8Array;
}

/** Standard deviations at which g is clamped. The 0.13 % of texels beyond become ink together. */
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
 * Encodes thresholds for the texture. A byte is enough: edges lie between texels, where the texture unit interpolates. Half
 * floats cost a software rasterizer a third of the frame time.
 */
export function encodeThresholds(size: number, thresholds: Float32Array): ThresholdLevel {
  const encoded = new Uint8Array(thresholds.length);
  for (let i = 0; i < thresholds.length; i++) {
    const g = Math.max(-LIMIT, Math.min(LIMIT, normalQuantile(thresholds[i])));
    // Rounded away from the middle, so that a threshold and its complement stay symmetric.
    encoded[i] = g < 0 ? Math.ceil(127.5 * (1 + g / LIMIT) - 0.5) : Math.floor(127.5 * (1 + g / LIMIT) + 0.5);
  }
  return { size, thresholds, encoded };
}
