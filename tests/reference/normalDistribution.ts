/** Φ, by Abramowitz and Stegun 7.1.26 for the error function: to 1.5e-7. */
export function normalDistribution(g: number): number {
  const x = Math.abs(g) / Math.SQRT2;
  const t = 1 / (1 + 0.3275911 * x);
  const polynomial = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  const erf = 1 - polynomial * Math.exp(-x * x);
  return g < 0 ? 0.5 * (1 - erf) : 0.5 * (1 + erf);
}
