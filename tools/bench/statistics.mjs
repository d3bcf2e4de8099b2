/** Beyond this ratio of new to old, with its whole interval, code counts as slower; beyond the inverse, as faster. */
export const SLOWER = 1.03;

/** The value in the middle, or the mean of the two in the middle. @param {readonly number[]} values */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

/**
 * The median and its 95 % interval, whatever the distribution: the true median lies below the k-th smallest of n values
 * exactly if fewer than k of n fair coins fall heads. Of fewer than six values the interval is all of them, which is not
 * quite 95 %.
 *
 * @param {readonly number[]} values
 * @returns {[median: number, low: number, high: number]}
 */
export function medianInterval(values) {
  const n = values.length;
  const sorted = [...values].sort((a, b) => a - b);
  let k = 0;
  let probability = 0.5 ** n;
  while (probability <= 0.025) {
    k++;
    probability += 0.5 ** n * binomial(n, k);
  }
  const below = Math.max(0, k - 1);
  return [median(values), sorted[below], sorted[n - 1 - below]];
}

function binomial(n, k) {
  let product = 1;
  for (let i = 1; i <= k; i++) product *= (n - k + i) / i;
  return product;
}

/** Ratios of values of the same turn. @param {readonly number[]} over @param {readonly number[]} under */
export const ratios = (over, under) => over.map((value, turn) => value / under[turn]);

/** Whether an interval of ratios, new to old, means slower, faster or neither. @param {readonly number[]} interval */
export function verdict([, low, high]) {
  if (low > SLOWER) return 'slower';
  return high < 1 / SLOWER ? 'faster' : 'same';
}

/** Quantiles of Student's t at 0.975, for 1, 2, … degrees of freedom; beyond them the normal distribution's will do. */
const STUDENT = [12.71, 4.3, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23];

/**
 * The exponent of the power law through `points`, by least squares of the logarithms, with its 95 % interval.
 *
 * @param {readonly (readonly [size: number, time: number])[]} points - three or more
 * @returns {[exponent: number, low: number, high: number]}
 */
export function fitExponent(points) {
  const x = points.map(([size]) => Math.log(size));
  const y = points.map(([, time]) => Math.log(time));
  const [meanX, meanY] = [mean(x), mean(y)];
  const spread = sum(x.map((value) => (value - meanX) ** 2));
  const exponent = sum(x.map((value, i) => (value - meanX) * (y[i] - meanY))) / spread;
  const residue = sum(x.map((value, i) => (y[i] - meanY - exponent * (value - meanX)) ** 2));
  const freedom = points.length - 2;
  const margin = (STUDENT[freedom - 1] ?? 1.96) * Math.sqrt(residue / freedom / spread);
  return [exponent, exponent - margin, exponent + margin];
}

const sum = (values) => values.reduce((total, value) => total + value, 0);
const mean = (values) => sum(values) / values.length;
