import { ModelError } from '../common/ModelError.js';
import { boundsOf, type PlainMesh } from './PlainMesh.js';

/** The centre of the bounding box of points, and the distance from there to the farthest point. */
export interface Extent {
  centre: [number, number, number];
  radius: number;
}

/**
 * Moves and scales a mesh, in place, so that its bounding box is centred at the origin and its farthest vertex lies at distance 1. Stroke
 * scales then mean the same on every model, and coordinates far from the origin do not lose precision. Broken triangles must be removed
 * first.
 *
 * @returns the extent before
 * @throws ModelError if all vertices lie at one point
 */
export function fitModel({ positions }: PlainMesh): Extent {
  const extent = measureExtent(positions);
  const {
    centre: [x, y, z],
    radius,
  } = extent;
  for (let i = 0; i < positions.length; i += 3) {
    positions[i] = (positions[i] - x) / radius;
    positions[i + 1] = (positions[i + 1] - y) / radius;
    positions[i + 2] = (positions[i + 2] - z) / radius;
  }
  return extent;
}

/**
 * Measures the extent of points, given as xyz.
 *
 * @throws ModelError if all points coincide
 */
export function measureExtent(positions: ArrayLike<number>): Extent {
  const { low, high } = boundsOf(positions);
  const centre = [0, 1, 2].map((axis) => low[axis] / 2 + high[axis] / 2) as [number, number, number];
  const [x, y, z] = centre;
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [dx, dy, dz] = [positions[i] - x, positions[i + 1] - y, positions[i + 2] - z];
    squared = Math.max(squared, dx * dx + dy * dy + dz * dz);
  }
  const radius = Math.sqrt(squared);
  if (!(radius > 0 && radius < Infinity))
    throw new ModelError('The model has no size: all its points lie at one place.');
  return { centre, radius };
}

/** Points farther from the origin than this multiple of their size are visibly rounded in single precision. */
export const FAR = 8;

/**
 * Converts points to single precision. Points far from the origin are moved there first; models are centred later anyway.
 *
 * @param points xyz of each; NaN stays NaN
 * @param indices of the points that count; by default all
 */
export function nearFloats(points: ArrayLike<number>, indices?: ArrayLike<number>): Float32Array {
  const centre = farCentre(points, FAR, indices);
  if (!centre) return Float32Array.from(points);
  const near = new Float32Array(points.length);
  for (let i = 0; i < near.length; i++) near[i] = points[i] - centre[i % 3];
  return near;
}

/**
 * The centre of points that lie far from the origin; undefined if they do not.
 *
 * @param points xyz of each; NaN ones do not count
 * @param far this multiple of their size
 * @param indices of the points that count; by default all
 */
export function farCentre(
  points: ArrayLike<number>,
  far: number,
  indices?: ArrayLike<number>,
): readonly number[] | undefined {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const count = indices?.length ?? points.length / 3;
  for (let i = 0; i < count; i++) {
    const at = 3 * (indices ? indices[i] : i);
    const sum = points[at] + points[at + 1] + points[at + 2];
    // Skips NaN and infinite points.
    if (sum - sum !== 0) continue;
    for (let axis = 0; axis < 3; axis++) {
      if (points[at + axis] < low[axis]) low[axis] = points[at + axis];
      if (points[at + axis] > high[axis]) high[axis] = points[at + axis];
    }
  }
  const size = Math.hypot(...high.map((value, axis) => value - low[axis]));
  const centre = low.map((value, axis) => value / 2 + high[axis] / 2);
  return size > 0 && size < Infinity && Math.hypot(...centre) >= far * size ? centre : undefined;
}
