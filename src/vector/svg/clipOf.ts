import type { Material, Plane } from 'three';
import type { Clip, ClipPlane } from '../paint/Clip.js';

/** The planes that clip everything, with those of a material; null for none. */
export function clipOf(
  { clippingPlanes, clipIntersection }: Pick<Material, 'clippingPlanes' | 'clipIntersection'>,
  everywhere: readonly Plane[],
): Clip | null {
  const own = clippingPlanes ?? [];
  if (own.length + everywhere.length === 0) return null;
  const each = clipIntersection ? everywhere : [...everywhere, ...own];
  return { each: each.map(numbersOf), together: clipIntersection ? own.map(numbersOf) : [] };
}

/** The clipping planes of a material's shadow: planes that clip everything do not clip shadows. */
export const shadowClipOf = (material: Material): Clip | null => (material.clipShadows ? clipOf(material, []) : null);

const numbersOf = ({ normal: { x, y, z }, constant }: Plane): ClipPlane => [x, y, z, constant];
