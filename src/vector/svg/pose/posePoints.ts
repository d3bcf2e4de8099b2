import { Matrix3, Matrix4, type Mesh, Vector3 } from 'three';
import { POINT_WORDS } from '../../../mesh/bake/outlineLayout.js';
import type { OutlineMesh } from '../../outlines/OutlineMesh.js';
import type { PosedVertices } from './posedVertices.js';

/** Points of outlines: positions, unit normals, and six numbers of the curvature each. */
export interface OutlinePoints {
  positions: Float32Array;
  normals: Float32Array;
  curvatures: Float32Array;
}

/** The word of a point that holds the index of its vertex. */
const VERTEX_WORD = 7;

/**
 * Deforms points of outlines as shaders/outlines/points.glsl does: with skinning alone their normals rotate; with morph targets only the
 * normals of vertices are known. Rotates the curvatures in place.
 *
 * @param words that the points were read from
 */
export function posePoints(
  { geometry }: Mesh,
  words: Uint32Array,
  { positions, normals, curvatures }: OutlinePoints,
  posed: PosedVertices,
): Pick<OutlineMesh, 'positions' | 'normals'> {
  // The layout of corners has no vertices to take the pose from; it does not deform on the canvas either.
  if (!posed.toRest || geometry.userData.hatching?.layout === 'corner') return { positions, normals };
  const hasMorphs = geometry.morphAttributes.position !== undefined;
  const moved = { positions: new Float64Array(positions.length), normals: Float64Array.from(normals) };
  const vector = new Vector3();
  for (let p = 0; 3 * p < positions.length; p++) {
    const vertex = words[POINT_WORDS * p + VERTEX_WORD];
    for (let k = 0; k < 3; k++) moved.positions[3 * p + k] = posed.positions[3 * vertex + k];
    const turn = hasMorphs ? null : turnOf(posed.toRest, vertex);
    if (turn) {
      vector.fromArray(normals, 3 * p).applyMatrix3(turn);
      turnTensor(curvatures, 6 * p, turn);
    } else if (posed.normals) {
      vector.fromArray(posed.normals, 3 * vertex).normalize();
      if (vector.lengthSq() === 0) continue;
    }
    vector.toArray(moved.normals as unknown as number[], 3 * p);
  }
  return moved;
}

/** The rotation of a vertex by its skin (shaders/perTriangle/turns.glsl); null for one that mirrors or flattens. */
function turnOf(toRest: Float64Array, vertex: number): Matrix3 | null {
  const skin = new Matrix3().fromArray(toRest, 9 * vertex);
  if (!(skin.determinant() > 0)) return null;
  const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
  new Matrix4().setFromMatrix3(skin.invert()).extractBasis(x, y, z);
  x.normalize();
  y.addScaledVector(x, -x.dot(y)).normalize();
  z.crossVectors(x, y);
  return new Matrix3().setFromMatrix4(new Matrix4().makeBasis(x, y, z));
}

/** Rotates a symmetric tensor, xx xy xz yy yz zz. */
function turnTensor(numbers: Float32Array, o: number, turn: Matrix3): void {
  const [xx, xy, xz, yy, yz, zz] = numbers.subarray(o, o + 6);
  const tensor = new Matrix3().set(xx, xy, xz, xy, yy, yz, xz, yz, zz);
  const { elements: e } = tensor.premultiply(turn).multiply(new Matrix3().copy(turn).transpose());
  numbers.set([e[0], e[3], e[6], e[4], e[7], e[8]], o);
}
