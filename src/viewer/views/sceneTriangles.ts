import { FrontSide, type Material, Matrix4, type Mesh, type Object3D, Vector3 } from 'three';
import { drawnMeshes, placements, rangesOf } from '../drawing/meshes.js';
import type { ViewTriangles } from './viewSurface.js';

/** The maximum number of triangles that are read; of larger scenes, each stands for some of its neighbours. */
const MOST_TRIANGLES = 200_000;

const isSeen = ({ visible, transparent, opacity }: Material): boolean => visible && !(transparent && opacity === 0);

/** The visible triangles of a scene in its present pose, in the space of the parent of its root. */
export function sceneTriangles(root: Object3D): ViewTriangles {
  root.updateWorldMatrix(true, true);
  const toParent = root.parent ? new Matrix4().copy(root.parent.matrixWorld).invert() : new Matrix4();
  const parts = drawnMeshes(root).flatMap((mesh) =>
    [false, true].flatMap((isSingleSided) =>
      rangesOf(mesh, (material) => isSeen(material) && (material.side === FrontSide) === isSingleSided).flatMap(
        (range) => placements(mesh).map((matrix) => ({ mesh, matrix, isSingleSided, ...range })),
      ),
    ),
  );
  const total = parts.reduce((sum, { count }) => sum + Math.floor(count / 3), 0);
  const step = Math.max(1, Math.ceil(total / MOST_TRIANGLES));
  const positions: number[] = [];
  const isSingleSided: number[] = [];
  const ofVertices: number[] = [];
  for (const [number, part] of parts.entries()) {
    const matrix = new Matrix4().multiplyMatrices(toParent, part.matrix);
    const isMirrored = matrix.determinant() < 0;
    for (let corner = part.start; corner + 2 < part.start + part.count; corner += 3 * step) {
      const triangle = cornersOf(
        part.mesh,
        matrix,
        isMirrored ? [corner, corner + 2, corner + 1] : [corner, corner + 1, corner + 2],
      );
      if (!triangle.every(Number.isFinite)) continue;
      positions.push(...triangle);
      isSingleSided.push(Number(part.isSingleSided));
      ofVertices.push(number, number, number);
    }
  }
  return {
    positions: Float32Array.from(positions),
    indices: null,
    isSingleSided: Uint8Array.from(isSingleSided),
    parts: { names: parts.map(({ mesh }) => mesh.name), ofVertices: Uint32Array.from(ofVertices) },
  };
}

const point = new Vector3();

function cornersOf(mesh: Mesh, matrix: Matrix4, corners: readonly number[]): number[] {
  const { index } = mesh.geometry;
  return corners.flatMap((corner) =>
    mesh
      .getVertexPosition(index ? index.getX(corner) : corner, point)
      .applyMatrix4(matrix)
      .toArray(),
  );
}
