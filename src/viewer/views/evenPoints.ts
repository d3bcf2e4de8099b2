import type { ViewSurface } from './viewSurface.js';

/** The number of points. */
const POINTS = 3000;

/** Points spread evenly over a surface. The same surface gets the same points. */
export function evenPoints({ positions, indices, areas, area }: ViewSurface): Float32Array {
  const points = new Float32Array(3 * POINTS);
  const each = area / POINTS;
  let owed = each / 2;
  let number = 0;
  for (let triangle = 0; triangle < areas.length; triangle++) {
    owed += areas[triangle];
    for (; owed >= each && number < POINTS; owed -= each) addPoint(points, number++, positions, indices, 3 * triangle);
  }
  return points.subarray(0, 3 * number);
}

function addPoint(
  points: Float32Array,
  number: number,
  positions: Float32Array,
  indices: Uint32Array,
  corner: number,
): void {
  // The golden ratio and its kin spread the points of a large triangle evenly.
  let s = (0.5 + number * 0.7548776662466927) % 1;
  let t = (0.5 + number * 0.5698402909980532) % 1;
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  const a = 3 * indices[corner];
  const b = 3 * indices[corner + 1];
  const c = 3 * indices[corner + 2];
  for (let k = 0; k < 3; k++) {
    points[3 * number + k] = (1 - s - t) * positions[a + k] + s * positions[b + k] + t * positions[c + k];
  }
}
