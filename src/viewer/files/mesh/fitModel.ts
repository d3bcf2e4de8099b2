import { ModelError } from '../common/ModelError.js';
import { boundsOf } from './boundsOf.js';
import type { PlainMesh } from './PlainMesh.js';

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
