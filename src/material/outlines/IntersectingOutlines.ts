import type { Material, Mesh } from 'three';

/** Outlines as far as lines where their mesh meets others need them. */
export interface IntersectingOutlines {
  readonly mesh: Mesh | null;
  readonly material: Material;
}

/** Whether outlines draw lines where their surface meets others. */
export const wantsIntersections = ({ material }: IntersectingOutlines): boolean =>
  'intersections' in material && material.intersections === true;
