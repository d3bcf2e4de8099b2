import { type BufferGeometry, type Color, Matrix3, type Matrix4, Mesh, type Object3D, Vector3 } from 'three';
import { checkTriangleCount } from './checkTriangleCount.js';
import type { PlainMesh } from './PlainMesh.js';
import { placements } from './placements.js';

/**
 * Every mesh below `root`, in its place and in the pose it was saved in, as one mesh: one bake, one draw call. The
 * colours of materials and vertices become vertex colours; textures are left out.
 *
 * @throws ModelError if there are no triangles, or too many
 */
export function mergeScene(root: Object3D): PlainMesh {
  root.updateMatrixWorld(true);
  const placed = placedMeshes(root);
  let vertexCount = 0;
  let cornerCount = 0;
  for (const { mesh } of placed) {
    vertexCount += mesh.geometry.getAttribute('position').count;
    cornerCount += drawnCorners(mesh.geometry).count;
  }
  checkTriangleCount(cornerCount / 3);
  const positions = new Float32Array(3 * vertexCount);
  const normals = placed.every(({ mesh }) => hasUsableNormals(mesh)) ? new Float32Array(3 * vertexCount) : null;
  const colors = placed.some(({ mesh }) => isColored(mesh)) ? new Float32Array(3 * vertexCount) : null;
  const indices = new Uint32Array(cornerCount);

  let vertex = 0;
  let corner = 0;
  for (const { mesh, matrix } of placed) {
    writeVertices(mesh, matrix, vertex, positions, normals);
    if (colors) writeColors(mesh, vertex, colors);
    corner = writeIndices(mesh.geometry, matrix.determinant() < 0, vertex, indices, corner);
    vertex += mesh.geometry.getAttribute('position').count;
  }
  return { positions, normals, colors, indices };
}

interface PlacedMesh {
  mesh: Mesh;
  matrix: Matrix4;
}

function placedMeshes(root: Object3D): PlacedMesh[] {
  const placed: PlacedMesh[] = [];
  root.traverseVisible((object) => {
    if (!(object instanceof Mesh) || !object.geometry.getAttribute('position')) return;
    for (const matrix of placements(object)) placed.push({ mesh: object, matrix });
  });
  return placed;
}

function isDeformed(mesh: Mesh): boolean {
  return 'isSkinnedMesh' in mesh || (mesh.morphTargetInfluences?.some((influence) => influence !== 0) ?? false);
}

/** The normals of a skinned or morphed mesh are not deformed here. They are computed from the surface later. */
function hasUsableNormals(mesh: Mesh): boolean {
  return mesh.geometry.getAttribute('normal') !== undefined && !isDeformed(mesh);
}

function materialColor(mesh: Mesh): Color | undefined {
  const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
  return (material as { color?: Color } | undefined)?.color;
}

function isColored(mesh: Mesh): boolean {
  const color = materialColor(mesh);
  return mesh.geometry.getAttribute('color') !== undefined || (color !== undefined && color.getHex() !== 0xffffff);
}

function writeVertices(
  mesh: Mesh,
  matrix: Matrix4,
  start: number,
  positions: Float32Array,
  normals: Float32Array | null,
): void {
  const count = mesh.geometry.getAttribute('position').count;
  const normal = mesh.geometry.getAttribute('normal');
  const normalMatrix = new Matrix3().getNormalMatrix(matrix);
  const deformed = isDeformed(mesh);
  const source = mesh.geometry.getAttribute('position');
  const vector = new Vector3();
  for (let i = 0; i < count; i++) {
    if (deformed) mesh.getVertexPosition(i, vector);
    else vector.fromBufferAttribute(source, i);
    vector.applyMatrix4(matrix).toArray(positions, 3 * (start + i));
    if (normals)
      vector
        .fromBufferAttribute(normal, i)
        .applyMatrix3(normalMatrix)
        .normalize()
        .toArray(normals, 3 * (start + i));
  }
}

function writeColors(mesh: Mesh, start: number, colors: Float32Array): void {
  const count = mesh.geometry.getAttribute('position').count;
  const attribute = mesh.geometry.getAttribute('color');
  const { r, g, b } = materialColor(mesh) ?? { r: 1, g: 1, b: 1 };
  for (let i = 0; i < count; i++) {
    const at = 3 * (start + i);
    colors[at] = r * (attribute?.getX(i) ?? 1);
    colors[at + 1] = g * (attribute?.getY(i) ?? 1);
    colors[at + 2] = b * (attribute?.getZ(i) ?? 1);
  }
}

function drawnCorners(geometry: BufferGeometry): { start: number; count: number } {
  const available = geometry.index?.count ?? geometry.getAttribute('position').count;
  const start = Math.min(geometry.drawRange.start, available);
  const count = Math.min(geometry.drawRange.count, available - start);
  return { start, count: count - (count % 3) };
}

/** Copies the indices. A mirroring matrix turns triangles inside out, so their winding is reversed. */
function writeIndices(
  geometry: BufferGeometry,
  mirrored: boolean,
  firstVertex: number,
  indices: Uint32Array,
  at: number,
): number {
  const { start, count } = drawnCorners(geometry);
  const order = mirrored ? [0, 2, 1] : [0, 1, 2];
  const vertexCount = geometry.getAttribute('position').count;
  let to = at;
  for (let corner = start; corner < start + count; corner += 3) {
    for (const k of order) {
      const vertex = geometry.index ? geometry.index.getX(corner + k) : corner + k;
      // An index out of range must not refer to a vertex of the next mesh. This one is out of range in the merged mesh
      // too.
      indices[to++] = vertex < vertexCount ? firstVertex + vertex : 0xffffffff;
    }
  }
  return to;
}
