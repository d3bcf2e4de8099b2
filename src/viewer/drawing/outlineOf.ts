/** The maximum number of points, enough to show the outline of a model. */
const OUTLINE_POINTS = 20_000;

/** An even sample of a mesh's vertices. */
export function outlineOf(positions: Float32Array): Float32Array {
  const count = positions.length / 3;
  const step = Math.ceil(count / OUTLINE_POINTS);
  const outline = new Float32Array(3 * Math.ceil(count / step));
  for (let i = 0; i < count; i += step) outline.set(positions.subarray(3 * i, 3 * i + 3), 3 * (i / step));
  return outline;
}
