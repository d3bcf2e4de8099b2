import { boundsOf } from './boundsOf.js';
import { forEachTriangle } from './triangleAreas.js';

/** How far above the lowest point a vertex may lie and still touch the ground, as a share of the model's extent. */
const CONTACT = 0.005;
/** A model stands firmly if it can be tilted by 20 degrees in any direction and does not fall over. */
const TILT = Math.tan((20 * Math.PI) / 180);
/** The number of directions in which it is tilted. */
const DIRECTIONS = Array.from({ length: 24 }, (_, i) => {
  const angle = (2 * Math.PI * i) / 24;
  return [Math.cos(angle), Math.sin(angle)] as const;
});

/**
 * Whether a model, hollow and of one material, would stay standing on level ground: on its wheels or feet as well as on a flat side.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param up the axis that points up
 */
export function standsFirmly(positions: ArrayLike<number>, indices: ArrayLike<number> | null, up: 'y' | 'z'): boolean {
  const height = up === 'y' ? 1 : 2;
  const [u, v] = [(height + 1) % 3, (height + 2) % 3];
  const { low, high } = boundsOf(positions);
  const lowest = low[height];
  const extent = Math.max(...high.map((value, axis) => value - low[axis]));
  const centre = centreOfArea(positions, indices);
  /** How far the vertices on the ground reach in each direction, from the point below the centre. */
  const reach = DIRECTIONS.map(() => -Infinity);
  for (let i = 0; i < positions.length; i += 3) {
    if (positions[i + height] - lowest > CONTACT * extent) continue;
    DIRECTIONS.forEach(([cos, sin], k) => {
      reach[k] = Math.max(reach[k], cos * (positions[i + u] - centre[u]) + sin * (positions[i + v] - centre[v]));
    });
  }
  return Math.min(...reach) > TILT * (centre[height] - lowest);
}

function centreOfArea(positions: ArrayLike<number>, indices: ArrayLike<number> | null): number[] {
  let [x, y, z, total] = [0, 0, 0, 0];
  forEachTriangle(positions, indices, (a, b, c, area) => {
    total += area;
    x += area * (positions[a] + positions[b] + positions[c]);
    y += area * (positions[a + 1] + positions[b + 1] + positions[c + 1]);
    z += area * (positions[a + 2] + positions[b + 2] + positions[c + 2]);
  });
  return [x, y, z].map((sum) => sum / (3 * total));
}
