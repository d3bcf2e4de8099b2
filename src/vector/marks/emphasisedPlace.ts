import type { Vec3 } from '../../look/vectors.js';
import type { Projection } from '../Projection.js';
import type { EmphasisedPlace } from '../shading/emphasis.js';

/** The properties of a place that emphasis depends on. */
export function emphasisedPlace(world: Vec3, projection: Projection): EmphasisedPlace {
  const view = projection.toView(world);
  const [x, y] = projection.project(...view);
  return { world, depth: -view[2], onPicture: [x / projection.width, 1 - y / projection.height] };
}
