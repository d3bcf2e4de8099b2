/** This many points show well enough how far a model reaches. */
const OUTLINE_POINTS = 20_000;

/** Some of the points of a mesh, evenly chosen. */
export function outlineOf(positions: Float32Array): Float32Array {
  const count = positions.length / 3;
  const step = Math.ceil(count / OUTLINE_POINTS);
  const outline = new Float32Array(3 * Math.ceil(count / step));
  for (let i = 0; i < count; i += step) outline.set(positions.subarray(3 * i, 3 * i + 3), 3 * (i / step));
  return outline;
}
