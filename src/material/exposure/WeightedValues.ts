/** The number of bins: finer than differences of tone that are visible. */
const BINS = 4096;

/** A histogram of weighted numbers from 0 on, and its quantiles. Emptying it keeps its memory. */
export class WeightedValues {
  private values = new Float64Array(1024);
  private weights = new Float64Array(1024);
  private count = 0;
  private readonly bins = new Float64Array(BINS);

  clear(): void {
    this.count = 0;
  }

  get isEmpty(): boolean {
    return this.count === 0;
  }

  /** Adds a value. Values that are not finite or have no weight are left out. */
  add(value: number, weight: number): void {
    if (!(value >= 0 && value < Infinity && weight > 0 && weight < Infinity)) return;
    if (this.count === this.values.length) this.grow();
    this.values[this.count] = value;
    this.weights[this.count++] = weight;
  }

  /**
   * The value below which a share of the weight lies, to 1/4096 of the greatest value; 0 if the histogram is empty.
   *
   * @param share from 0 to 1
   */
  quantile(share: number): number {
    const { bins, values, weights, count } = this;
    let [most, all] = [0, 0];
    for (let i = 0; i < count; i++) {
      if (values[i] > most) most = values[i];
      all += weights[i];
    }
    if (most === 0) return 0;
    bins.fill(0);
    const perValue = (BINS - 1) / most;
    for (let i = 0; i < count; i++) bins[Math.round(values[i] * perValue)] += weights[i];
    const wanted = share * all;
    let sum = 0;
    for (let bin = 0; bin < BINS; bin++) {
      const next = sum + bins[bin];
      if (next >= wanted && next > sum) return Math.max(0, bin - 0.5 + (wanted - sum) / (next - sum)) / perValue;
      sum = next;
    }
    return most;
  }

  private grow(): void {
    const { values, weights } = this;
    this.values = new Float64Array(2 * values.length);
    this.weights = new Float64Array(2 * weights.length);
    this.values.set(values);
    this.weights.set(weights);
  }
}
