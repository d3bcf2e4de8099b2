/** Points this near to each other are at one place, as a share of the size of all together. */
const TOLERANCE = 1e-6;

/**
 * For each point the first one at the same place, but for rounding: surfaces go on across seams of uvs and normals.
 *
 * @param coordinate of a point along an axis, from 0 to 2
 */
export function placesOf(count: number, coordinate: (point: number, axis: number) => number): Uint32Array {
  let size = 0;
  for (let p = 0; p < count; p++) {
    for (let axis = 0; axis < 3; axis++) size = Math.max(size, Math.abs(coordinate(p, axis)));
  }
  const cell = size * TOLERANCE || 1;
  const known = new Map<string, number>();
  const places = new Uint32Array(count);
  for (let p = 0; p < count; p++) {
    // −0 is written as 0.
    const key = [0, 1, 2].map((axis) => Math.round(coordinate(p, axis) / cell) || 0).join();
    const first = known.get(key);
    places[p] = first ?? p;
    if (first === undefined) known.set(key, p);
  }
  return places;
}
