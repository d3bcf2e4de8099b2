/** A line of evenly spaced points. */
export interface Path {
  xs: Float64Array;
  ys: Float64Array;
}

/** Points at even distances of about `spacing` along a line x0, y0, x1, y1, …, its ends among them; at least two. */
export function resample(points: ArrayLike<number>, spacing: number): Path {
  const count = points.length / 2;
  const lengths = new Float64Array(count);
  for (let i = 1; i < count; i++) {
    lengths[i] = lengths[i - 1] + Math.hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
  }
  const total = lengths[count - 1];
  const steps = Math.max(1, Math.round(total / spacing));
  const path: Path = { xs: new Float64Array(steps + 1), ys: new Float64Array(steps + 1) };
  let segment = 1;
  for (let i = 0; i <= steps; i++) {
    const wanted = (total * i) / steps;
    while (segment < count - 1 && lengths[segment] < wanted) segment++;
    const start = segment - 1;
    const share = count > 1 ? (wanted - lengths[start]) / (lengths[segment] - lengths[start] || 1) : 0;
    const end = count > 1 ? segment : start;
    path.xs[i] = points[2 * start] + share * (points[2 * end] - points[2 * start]);
    path.ys[i] = points[2 * start + 1] + share * (points[2 * end + 1] - points[2 * start + 1]);
  }
  return path;
}

/** Smooths values by a Gaussian of `deviation` samples, with point reflection at the ends, which stay fixed. */
export function smooth(values: Float64Array, deviation: number): Float64Array {
  const reach = Math.min(values.length - 1, Math.ceil(3 * deviation));
  const weights = Array.from({ length: reach + 1 }, (_, i) => Math.exp((-0.5 * i * i) / (deviation * deviation)));
  const last = values.length - 1;
  const at = (i: number): number => {
    if (i < 0) return 2 * values[0] - values[-i];
    return i > last ? 2 * values[last] - values[2 * last - i] : values[i];
  };
  return values.map((value, i) => {
    let sum = value;
    let weight = 1;
    for (let step = 1; step <= reach; step++) {
      sum += weights[step] * (at(i - step) + at(i + step));
      weight += 2 * weights[step];
    }
    return sum / weight;
  });
}
