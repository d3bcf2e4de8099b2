/**
 * The coefficients c₀, c₁, … of e^(−time·(1 − x)) ≈ Σ cₖ·Tₖ(x) on [−1, 1], with Tₖ the Chebyshev polynomials. They are modified
 * Bessel functions of the first kind: c₀ ∝ I₀(time), cₖ ∝ 2·Iₖ(time). They fall off beyond k ≈ √time. The series ends where
 * the remaining coefficients sum to less than `tolerance`. The coefficients are scaled to sum to 1, so a constant keeps its
 * value.
 *
 * If x is a matrix of weighted means, the series gives the result of `time` small steps of heat flow in only about
 * √(2·time·ln(1/tolerance)) steps.
 */
export function heatSeries(time: number, tolerance: number): number[] {
  // Miller's algorithm: the recurrence I(k−1) = I(k+1) + 2k/time·I(k) is stable downwards, from any small value.
  const values: number[] = [];
  let last = 0;
  let value = 1e-150;
  for (let k = Math.ceil(Math.sqrt(40 * time)) + 8; k > 0; k--) {
    [last, value] = [value, last + ((2 * k) / time) * value];
    values[k - 1] = value;
  }
  const coefficients = values.map((bessel, k) => (k === 0 ? 1 : 2) * bessel);
  const total = sum(coefficients);
  let rest = 0;
  while (rest + coefficients.at(-1)! < tolerance * total) rest += coefficients.pop()!;
  const kept = sum(coefficients);
  return coefficients.map((coefficient) => coefficient / kept);
}

const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);
