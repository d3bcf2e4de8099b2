import type { ViewSurface } from './viewSurface.js';

/** The number of points. */
const POINTS = 3000;

/** Points spread evenly over a surface. The same surface gets the same points. */
export function evenPoints({ positions, indices, areas, area }: ViewSurface): Float32Array {
  const points: number[] = [];
  const each = area / POINTS;
  let owed = each / 2;
  let number = 0;
  for (let triangle = 0; triangle < areas.length; triangle++) {
    owed += areas[triangle];
    for (; owed >= each; owed -= each) {
      // The golden ratio and its kin spread the points of a large triangle evenly.
      let s = (0.5 + number * 0.7548776662466927) % 1;
      let t = (0.5 + number * 0.5698402909980532) % 1;
      number++;
      if (s + t > 1) [s, t] = [1 - s, 1 - t];
      const [a, b, c] = [0, 1, 2].map((k) => 3 * indices[3 * triangle + k]);
      for (let k = 0; k < 3; k++) {
        points.push((1 - s - t) * positions[a + k] + s * positions[b + k] + t * positions[c + k]);
      }
    }
  }
  return Float32Array.from(points);
}
