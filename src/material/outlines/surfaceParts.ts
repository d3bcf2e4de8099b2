import type { Material, Mesh } from 'three';

/** A part of a mesh that is drawn with one material: its corners from `start` up to `end`. */
export interface SurfacePart {
  material: Material;
  start: number;
  end: number;
}

/**
 * The parts of a mesh that three.js draws: within its draw range, by groups if it has several materials, and only those with visible
 * materials.
 */
export function surfaceParts({ geometry, material }: Mesh): SurfacePart[] {
  const { index, attributes, drawRange, groups } = geometry;
  const count = (index ?? attributes.position)?.count ?? 0;
  const first = Math.max(0, drawRange.start);
  const last = Math.min(count, drawRange.start + drawRange.count);
  const parts = Array.isArray(material)
    ? groups.map(({ start, count: size, materialIndex = 0 }) => ({
        material: material[materialIndex],
        start: Math.max(first, start),
        end: Math.min(last, start + size),
      }))
    : [{ material, start: first, end: last }];
  return parts.filter((part) => part.material?.visible && part.end - part.start >= 3);
}
