/** Normalises the vector at `from` and writes it to `to`. If it is zero, it writes nothing and returns false. */
export function writeNormalized(
  source: Float32Array | Float64Array,
  from: number,
  target: Float32Array,
  to: number,
): boolean {
  const x = source[from];
  const y = source[from + 1];
  const z = source[from + 2];
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length === 0) return false;
  target[to] = x / length;
  target[to + 1] = y / length;
  target[to + 2] = z / length;
  return true;
}
