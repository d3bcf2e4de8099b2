import type { Material, Mesh, Object3D } from 'three';
import { meshesOf } from './meshesOf.js';

/** The visible meshes: neither hidden nor fully transparent. Glass counts as visible. */
export const drawnMeshes = (root: Object3D): Mesh[] =>
  meshesOf(root).filter((mesh) => isShown(mesh, root) && materialsOf(mesh).some(isSeen));

/** Marks the vertices of triangles whose material is visible. */
export function drawnVertices(mesh: Mesh): Uint8Array {
  const { index, attributes } = mesh.geometry;
  const drawn = new Uint8Array(attributes.position?.count ?? 0);
  for (const { start, count } of rangesOf(mesh, isSeen))
    for (let corner = start; corner < start + count; corner++) drawn[index ? index.getX(corner) : corner] = 1;
  return drawn;
}

/** The ranges of corners of a mesh whose material passes a test. As in three.js, groups count only with an array of materials. */
export function rangesOf(
  { geometry, material }: Mesh,
  counts: (material: Material) => boolean,
): { start: number; count: number }[] {
  const { index, attributes, groups } = geometry;
  const corners = index?.count ?? attributes.position?.count ?? 0;
  if (!Array.isArray(material)) return counts(material) ? [{ start: 0, count: corners }] : [];
  return groups
    .filter(({ materialIndex = 0 }) => material[materialIndex] && counts(material[materialIndex]))
    .map(({ start, count }) => ({ start, count: Math.min(count, corners - start) }));
}

const materialsOf = ({ material }: Mesh): Material[] => (Array.isArray(material) ? material : [material]);

export const isSeen = ({ visible, transparent, opacity }: Material): boolean =>
  visible && !(transparent && opacity === 0);

/** Whether a visible surface hides what is behind it: glass does not. */
export const isSolid = (material: Material & { transmission?: number }): boolean =>
  isSeen(material) && !material.transparent && (material.transmission ?? 0) === 0;

function isShown(mesh: Mesh, root: Object3D): boolean {
  for (let object: Object3D | null = mesh; object; object = object === root ? null : object.parent) {
    if (!object.visible) return false;
  }
  return true;
}
