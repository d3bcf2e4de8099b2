import { Box3, type Material, type Mesh, type Object3D, Vector3 } from 'three';
import { placements } from '../files/scenes/placements.js';
import { drawnMeshes, isSeen } from './drawnParts.js';

/** The most vertices that are looked at. */
const MOST_POINTS = 100_000;
/** A pose may reach so much farther than the first one and still stand on the same ground, as a share of the extent. */
const SAME_GROUND = 0.03;

/**
 * The box of what carries a scene in its present pose: of what is drawn and hides what lies behind it. A hidden part or a pane of glass does
 * not, unless there is nothing else.
 */
export function carryingBox(root: Object3D): Box3 {
  const drawn = drawnMeshes(root);
  const solid = boxOf(drawn, isSolid);
  return solid.isEmpty() ? boxOf(drawn, isSeen) : solid;
}

/** The box by which a scene stands on a ground: that of its first pose, or of all if others reach much farther, as a jump does. */
export function standingBox([first, ...others]: readonly Box3[]): Box3 {
  const all = others.reduce((box, other) => box.union(other), first.clone());
  const near = SAME_GROUND * all.min.distanceTo(all.max);
  const box = first.clone();
  for (const axis of ['x', 'y', 'z'] as const) {
    if (box.min[axis] - all.min[axis] > near) box.min[axis] = all.min[axis];
    if (all.max[axis] - box.max[axis] > near) box.max[axis] = all.max[axis];
  }
  return box;
}

/** The box of the triangles whose material counts. */
function boxOf(meshes: readonly Mesh[], counts: (material: Material) => boolean): Box3 {
  const box = new Box3();
  const point = new Vector3();
  const parts = meshes.flatMap((mesh) => rangesOf(mesh, counts).map((range) => ({ mesh, ...range })));
  const step = Math.ceil(parts.reduce((sum, { count }) => sum + count, 0) / MOST_POINTS) || 1;
  for (const { mesh, start, count } of parts) {
    const { index } = mesh.geometry;
    for (const matrix of placements(mesh)) {
      // A vertex that no triangle uses is not drawn.
      for (let corner = start; corner < start + count; corner += step) {
        mesh.getVertexPosition(index ? index.getX(corner) : corner, point).applyMatrix4(matrix);
        if (Number.isFinite(point.x + point.y + point.z)) box.expandByPoint(point);
      }
    }
  }
  return box;
}

/** The corners of a mesh whose material counts. As in three.js, groups count only if there are several materials. */
function rangesOf(
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

const isSolid = (material: Material & { transmission?: number }): boolean =>
  isSeen(material) && !material.transparent && (material.transmission ?? 0) === 0;
