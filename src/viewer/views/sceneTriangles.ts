import { FrontSide, type Material, Matrix4, type Mesh, type Object3D, Vector3 } from 'three';
import type { ModelParts } from '../drawing/ModelParts.js';
import { drawnMeshes, placements, rangesOf } from '../drawing/meshes.js';
import { signOf } from './landmarks.js';
import type { NamedPoints, ViewTriangles } from './viewSurface.js';

/** The maximum number of triangles that are read; of larger scenes, each stands for some of its neighbours. */
const MOST_TRIANGLES = 200_000;

const isSeen = ({ visible, transparent, opacity }: Material): boolean => visible && !(transparent && opacity === 0);

/** The number of triangles that stand for a part of a mesh that was joined from several. */
const PER_PART = 500;

/**
 * The visible triangles of a scene in its present pose, in the space of the parent of its root.
 *
 * @param joined the parts of a mesh that was joined from several
 */
export function sceneTriangles(root: Object3D, joined?: ModelParts): ViewTriangles {
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
    parts: joined
      ? pointsOf(joined, toParent)
      : { names: parts.map(({ mesh }) => mesh.name), ofVertices: Uint32Array.from(ofVertices) },
  };
}

/** Points on the parts whose names say whether they are in front. */
function pointsOf({ names, hidden, trianglesOf }: ModelParts, toParent: Matrix4): NamedPoints {
  const points: number[] = [];
  const ofVertices: number[] = [];
  for (const part of names.keys()) {
    if (hidden.includes(part) || signOf(names[part]) === 0) continue;
    const corners = trianglesOf(part, PER_PART);
    for (let i = 0; i < corners.length; i += 3) {
      points.push(...point.fromArray(corners, i).applyMatrix4(toParent).toArray());
      ofVertices.push(part);
    }
  }
  return { names, ofVertices: Uint32Array.from(ofVertices), points };
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
