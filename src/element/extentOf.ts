import { Box3, type InstancedMesh, type Material, type Mesh, type Object3D, Vector3 } from 'three';

/** The extent of the visible parts of a model. */
export interface Extent {
  /** The centre of the bounding box, in the units of the model. */
  middle: Vector3;
  /** The distance of the farthest point from the middle, in the units of the model. */
  radius: number;
  /** The distance of the farthest point from the vertical axis through the middle, in radii. */
  around: number;
  /** Half the height of the bounding box, in radii. */
  height: number;
}

/** The opacity below which a surface is invisible. */
const LEAST = 0.02;

const box = new Box3();
const place = new Vector3();

/** The extent of the visible parts: hidden and transparent ones do not count, unless there are no others. */
export function extentOf(model: Object3D): Extent {
  const all = model.getObjectsByProperty('isMesh', true) as Mesh[];
  const drawn = all.map(drawnOf);
  const seen = drawn.filter(({ vertices }) => vertices.includes(1));
  const parts = seen.length > 0 ? seen : all.map((mesh) => ({ mesh, vertices: everyVertex(mesh) }));
  box.makeEmpty();
  for (const { mesh, vertices } of parts) {
    if (isInstanced(mesh)) {
      if (!mesh.boundingBox) mesh.computeBoundingBox();
      box.union(new Box3().copy(mesh.boundingBox!).applyMatrix4(mesh.matrixWorld));
    } else eachPoint(mesh, vertices, (point) => box.expandByPoint(point));
  }
  const middle = box.getCenter(new Vector3());
  const size = box.getSize(place);
  const height = size.y / 2;
  // For instances only the bounding box is known.
  let [radius, around] = [size.length() / 2, Math.hypot(size.x, size.z) / 2];
  if (!parts.some(({ mesh }) => isInstanced(mesh))) {
    [radius, around] = [0, 0];
    for (const { mesh, vertices } of parts) {
      eachPoint(mesh, vertices, (point) => {
        point.sub(middle);
        radius = Math.max(radius, point.length());
        around = Math.max(around, Math.hypot(point.x, point.z));
      });
    }
  }
  const unit = radius > 0 && radius < Infinity ? radius : 1;
  return { middle, radius: unit, around: around / unit, height: height / unit };
}

/** @param call receives each marked and finite vertex of a mesh in its present pose, in world space. It may change the point */
function eachPoint(mesh: Mesh, vertices: Uint8Array, call: (point: Vector3) => void): void {
  const point = new Vector3();
  for (let i = 0; i < vertices.length; i++) {
    if (vertices[i] === 0) continue;
    mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld);
    if (Number.isFinite(point.x + point.y + point.z)) call(point);
  }
}

/** Marks the vertices of the visible parts of a mesh. */
function drawnOf(mesh: Mesh): { mesh: Mesh; vertices: Uint8Array } {
  const { geometry, material } = mesh;
  const { index, groups } = geometry;
  const vertices = everyVertex(mesh).fill(0);
  const ranges = Array.isArray(material)
    ? groups.map(({ start, count, materialIndex = 0 }) => ({ start, count, material: material[materialIndex] }))
    : [{ start: 0, count: Infinity, material }];
  for (const { start, count, material: one } of isShown(mesh) ? ranges : []) {
    if (!one || isClear(one)) continue;
    const end = Math.min(start + count, index?.count ?? vertices.length);
    for (let corner = start; corner < end; corner++) vertices[index ? index.getX(corner) : corner] = 1;
  }
  return { mesh, vertices };
}

const everyVertex = ({ geometry }: Mesh): Uint8Array =>
  new Uint8Array(geometry.getAttribute('position')?.count ?? 0).fill(1);

const isInstanced = (mesh: Mesh): mesh is InstancedMesh => 'isInstancedMesh' in mesh;

function isShown(mesh: Mesh): boolean {
  for (let object: Object3D | null = mesh; object; object = object.parent) if (!object.visible) return false;
  return true;
}

const isClear = ({ visible, transparent, opacity, alphaTest }: Material): boolean =>
  !visible || (transparent && opacity < LEAST) || opacity < alphaTest;
