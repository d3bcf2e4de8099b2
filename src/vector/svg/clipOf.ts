import type { Material, Plane } from 'three';
import type { Clip, ClipPlane } from '../paint/Clip.js';

/** The planes that clip everything, and how a material clips; null where nothing is clipped. */
export function clipOf(
  { clippingPlanes, clipIntersection }: Pick<Material, 'clippingPlanes' | 'clipIntersection'>,
  everywhere: readonly Plane[],
): Clip | null {
  const own = clippingPlanes ?? [];
  if (own.length + everywhere.length === 0) return null;
  const each = clipIntersection ? everywhere : [...everywhere, ...own];
  return { each: each.map(numbersOf), together: clipIntersection ? own.map(numbersOf) : [] };
}

/** How a material clips what casts its shadow: planes that clip everything never do. */
export const shadowClipOf = (material: Material): Clip | null => (material.clipShadows ? clipOf(material, []) : null);

const numbersOf = ({ normal: { x, y, z }, constant }: Plane): ClipPlane => [x, y, z, constant];
