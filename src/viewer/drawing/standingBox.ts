import { Box3, type Material, type Mesh, type Object3D, Vector3 } from 'three';
import { placements } from '../files/scenes/placements.js';
import { drawnMeshes, isSeen, isSolid, rangesOf } from './drawnParts.js';

/** The maximum number of sampled vertices. */
const MOST_POINTS = 100_000;
/** Poses stand on the first pose's ground if they extend beyond its box by no more than this share of the extent. */
const SAME_GROUND = 0.03;

/** The box of the parts that carry a scene in its present pose: visible and opaque ones, or all if there are none. */
export function carryingBox(root: Object3D): Box3 {
  const drawn = drawnMeshes(root);
  const solid = boxOf(drawn, isSolid);
  return solid.isEmpty() ? boxOf(drawn, isSeen) : solid;
}

/**
 * The box by which a scene stands on the ground: that of its first pose, or the union of all if others reach much farther, as in a jump.
 */
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

/** The box of the triangles whose material passes a test. */
function boxOf(meshes: readonly Mesh[], counts: (material: Material) => boolean): Box3 {
  const box = new Box3();
  const point = new Vector3();
  const parts = meshes.flatMap((mesh) => rangesOf(mesh, counts).map((range) => ({ mesh, ...range })));
  const step = Math.ceil(parts.reduce((sum, { count }) => sum + count, 0) / MOST_POINTS) || 1;
  for (const { mesh, start, count } of parts) {
    const { index } = mesh.geometry;
    for (const matrix of placements(mesh)) {
      // Unused vertices are not drawn.
      for (let corner = start; corner < start + count; corner += step) {
        mesh.getVertexPosition(index ? index.getX(corner) : corner, point).applyMatrix4(matrix);
        if (Number.isFinite(point.x + point.y + point.z)) box.expandByPoint(point);
      }
    }
  }
  return box;
}
