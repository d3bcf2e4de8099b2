import { Box3, type InstancedMesh, type Material, Matrix4, type Mesh, type Object3D, Vector3 } from 'three';

/** All meshes at or below an object. */
export function meshesOf(root: Object3D): Mesh[] {
  return root.getObjectsByProperty('isMesh', true) as Mesh[];
}

/** The visible meshes: neither hidden, nor on no layer, nor fully transparent. Glass counts as visible. */
export const drawnMeshes = (root: Object3D): Mesh[] =>
  meshesOf(root).filter((mesh) => isShown(mesh, root) && mesh.layers.mask !== 0 && materialsOf(mesh).some(isSeen));

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

const isSeen = ({ visible, transparent, opacity }: Material): boolean => visible && !(transparent && opacity === 0);

/** Whether a visible surface hides what is behind it: glass does not. */
export const isSolid = (material: Material & { transmission?: number }): boolean =>
  isSeen(material) && !material.transparent && (material.transmission ?? 0) === 0;

function isShown(mesh: Mesh, root: Object3D): boolean {
  for (let object: Object3D | null = mesh; object; object = object === root ? null : object.parent) {
    if (!object.visible) return false;
  }
  return true;
}

/** The world matrices of a mesh: one, or one per instance. World matrices must be up to date. */
export function placements(mesh: Mesh): Matrix4[] {
  if (!('isInstancedMesh' in mesh)) return [mesh.matrixWorld];
  const instanced = mesh as InstancedMesh;
  return Array.from({ length: instanced.count }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(i, matrix);
    return matrix.premultiply(mesh.matrixWorld);
  });
}

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

/** The maximum number of points by which a model is framed. */
const FRAMED_POINTS = 20_000;

/** An even sample of a mesh's vertices. */
export function someVertices(positions: Float32Array): Float32Array {
  const count = positions.length / 3;
  const step = Math.ceil(count / FRAMED_POINTS);
  const framedPoints = new Float32Array(3 * Math.ceil(count / step));
  for (let i = 0; i < count; i += step) framedPoints.set(positions.subarray(3 * i, 3 * i + 3), 3 * (i / step));
  return framedPoints;
}
