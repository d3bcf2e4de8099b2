import type { Material, Mesh, Object3D } from 'three';
import { meshesOf } from './meshesOf.js';

/** The visible meshes: neither hidden nor fully transparent. Glass counts as visible. */
export const drawnMeshes = (root: Object3D): Mesh[] =>
  meshesOf(root).filter((mesh) => isShown(mesh, root) && materialsOf(mesh).some(isSeen));

/** Marks the vertices of triangles whose material is visible. */
export function drawnVertices({ geometry, material }: Mesh): Uint8Array {
  const { index, groups } = geometry;
  const count = geometry.getAttribute('position')?.count ?? 0;
  const ranges = Array.isArray(material)
    ? groups.map(({ start, count: many, materialIndex = 0 }) => ({ start, many, one: material[materialIndex] }))
    : [{ start: 0, many: Infinity, one: material }];
  const drawn = new Uint8Array(count);
  for (const { start, many, one } of ranges) {
    if (!one || !isSeen(one)) continue;
    const end = Math.min(start + many, index?.count ?? count);
    for (let corner = start; corner < end; corner++) drawn[index ? index.getX(corner) : corner] = 1;
  }
  return drawn;
}

const materialsOf = ({ material }: Mesh): Material[] => (Array.isArray(material) ? material : [material]);

export const isSeen = ({ visible, transparent, opacity }: Material): boolean =>
  visible && !(transparent && opacity === 0);

function isShown(mesh: Mesh, root: Object3D): boolean {
  for (let object: Object3D | null = mesh; object; object = object === root ? null : object.parent) {
    if (!object.visible) return false;
  }
  return true;
}
