import { boundsOf } from './boundsOf.js';
import { areaOf } from './triangleAreas.js';

/** The maximum height of a contact vertex above the lowest point, as a share of the model's extent. */
const CONTACT = 0.005;
/** The slope of the tilt, 20 degrees in any direction, that a firmly standing model must survive. */
const TILT = Math.tan((20 * Math.PI) / 180);
/** Larger meshes are sampled by this many triangles, enough to find the centre. */
const SAMPLED_TRIANGLES = 250_000;
/** The directions of tilting. */
const DIRECTIONS = Array.from({ length: 24 }, (_, i) => {
  const angle = (2 * Math.PI * i) / 24;
  return { cos: Math.cos(angle), sin: Math.sin(angle) };
});

/**
 * Whether a hollow model of one material would stay standing on level ground, on wheels or feet as well as on a flat side.
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
  /** How far contact vertices reach in each direction from the point below the centre. */
  const reach = DIRECTIONS.map(() => -Infinity);
  const contact = CONTACT * extent;
  for (let i = 0; i < positions.length; i += 3) {
    if (positions[i + height] - lowest > contact) continue;
    const x = positions[i + u] - centre[u];
    const y = positions[i + v] - centre[v];
    // A plain loop for speed: large models have many contact vertices.
    for (let k = 0; k < DIRECTIONS.length; k++) {
      const { cos, sin } = DIRECTIONS[k];
      reach[k] = Math.max(reach[k], cos * x + sin * y);
    }
  }
  return Math.min(...reach) > TILT * (centre[height] - lowest);
}

/** The area-weighted centre of the triangles. */
function centreOfArea(positions: ArrayLike<number>, indices: ArrayLike<number> | null): number[] {
  let [x, y, z, total] = [0, 0, 0, 0];
  const count = indices?.length ?? positions.length / 3;
  const step = 3 * Math.ceil(count / 3 / SAMPLED_TRIANGLES);
  for (let corner = 0; corner + 2 < count; corner += step) {
    const a = 3 * (indices ? indices[corner] : corner);
    const b = 3 * (indices ? indices[corner + 1] : corner + 1);
    const c = 3 * (indices ? indices[corner + 2] : corner + 2);
    const area = areaOf(positions, a, b, c);
    total += area;
    x += area * (positions[a] + positions[b] + positions[c]);
    y += area * (positions[a + 1] + positions[b + 1] + positions[c + 1]);
    z += area * (positions[a + 2] + positions[b + 2] + positions[c + 2]);
  }
  return [x, y, z].map((sum) => sum / (3 * total));
}
