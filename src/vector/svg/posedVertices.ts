import {
  type BufferAttribute,
  type InstancedMesh,
  Matrix3,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
  Vector3,
} from 'three';
import { asPhase } from '../../mesh/phases.js';

/** The deformed vertices of a mesh, object space. */
export interface PosedVertices {
  /** Three numbers per vertex. */
  positions: Float64Array;
  /** Three numbers per vertex, of any length; null if the geometry has none. */
  normals: Float64Array | null;
  /**
   * Nine numbers per vertex of a mesh that deforms, column-major: the linear map from the pose back to rest, as in
   * shaders/perFragment/vertex.glsl. Null for a mesh at rest.
   */
  toRest: Float64Array | null;
}

type Attribute = BufferAttribute;

/** Vertices per step. */
const CHUNK = 4096;

/**
 * Deforms the vertices of a mesh by its morph targets and its skin. Yields its progress.
 *
 * @param instance index of the instance, if instances have their own morph targets; otherwise −1
 */
export function* posedVertices(mesh: Mesh, instance = -1): Generator<number, PosedVertices, void> {
  const { position, normal } = mesh.geometry.attributes;
  const posed: PosedVertices = {
    positions: yield* asPhase(numbersOf(position as Attribute), 0, 0.25),
    normals: normal ? yield* asPhase(numbersOf(normal as Attribute), 0.25, 0.5) : null,
    toRest: null,
  };
  const influences = influencesOf(mesh, instance);
  const isMorphed = influences.some((influence) => influence !== 0);
  const isSkinned = 'isSkinnedMesh' in mesh && (mesh as SkinnedMesh).skeleton !== undefined;
  if (!isMorphed && !isSkinned) return posed;
  posed.toRest = new Float64Array(9 * position.count);
  for (let v = 0; v < position.count; v++) new Matrix3().toArray(posed.toRest as unknown as number[], 9 * v);
  if (isMorphed) yield* asPhase(morph(mesh, influences, posed), 0.5, 0.75);
  if (isSkinned) yield* asPhase(skin(mesh as SkinnedMesh, posed), 0.75, 1);
  return posed;
}

/** The skinning matrix of the first bone, which stands for the whole skin; null for none, or one that flattens. */
export function firstBoneOf(mesh: Mesh): Matrix4 | null {
  if (!('isSkinnedMesh' in mesh)) return null;
  const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
  if (!skeleton?.bones.length) return null;
  skeleton.update();
  const matrix = new Matrix4().fromArray(skeleton.boneMatrices!).premultiply(bindMatrixInverse).multiply(bindMatrix);
  return matrix.determinant() === 0 ? null : matrix;
}

function* numbersOf(attribute: Attribute): Generator<number, Float64Array, void> {
  const numbers = new Float64Array(3 * attribute.count);
  for (let v = 0; v < attribute.count; v++) {
    if (v % CHUNK === CHUNK - 1) yield v / attribute.count;
    for (let k = 0; k < 3; k++) numbers[3 * v + k] = attribute.getComponent(v, k);
  }
  return numbers;
}

/** The influences of the morph targets. */
function influencesOf(mesh: Mesh, instance: number): number[] {
  const texture = instance < 0 ? null : (mesh as InstancedMesh).morphTexture;
  if (!texture) return mesh.morphTargetInfluences ?? [];
  // A row is an instance. Its first number is the weight of the base position.
  const { data, width } = texture.image as unknown as { data: Float32Array; width: number };
  return Array.from(data.subarray(width * instance + 1, width * (instance + 1)));
}

/** Adds morph targets to the numbers of a vertex, as three.js does. */
function addMorphs(
  numbers: Float64Array,
  targets: readonly Attribute[] | undefined,
  influences: readonly number[],
  isRelative: boolean,
): void {
  if (!targets) return;
  const rest = isRelative ? 1 : 1 - influences.reduce((sum, influence) => sum + influence, 0);
  const size = numbers.length / targets[0].count;
  for (let i = 0; i < numbers.length; i++) {
    const [vertex, k] = [Math.floor(i / size), i % size];
    let sum = rest * numbers[i];
    for (const [t, influence] of influences.entries()) {
      if (influence !== 0 && k < targets[t].itemSize) sum += influence * targets[t].getComponent(vertex, k);
    }
    numbers[i] = sum;
  }
}

function* morph(
  { geometry }: Mesh,
  influences: readonly number[],
  { positions, normals, toRest }: PosedVertices,
): Generator<number, void, void> {
  const { morphAttributes, morphTargetsRelative } = geometry;
  addMorphs(positions, morphAttributes.position as Attribute[] | undefined, influences, morphTargetsRelative);
  yield 0.4;
  if (!normals || !morphAttributes.normal) return;
  const before = normals.slice();
  addMorphs(normals, morphAttributes.normal as Attribute[], influences, morphTargetsRelative);
  const [from, to] = [new Vector3(), new Vector3()];
  for (let v = 0; 3 * v < normals.length; v++) {
    if (v % CHUNK === 0) yield 0.8 + (0.6 * v) / normals.length;
    rotationBetween(from.fromArray(normals, 3 * v), to.fromArray(before, 3 * v)).toArray(
      toRest as unknown as number[],
      9 * v,
    );
  }
}

function* skin(mesh: SkinnedMesh, { positions, normals, toRest }: PosedVertices): Generator<number, void, void> {
  const { skinIndex, skinWeight } = mesh.geometry.attributes;
  const { skeleton, bindMatrix, bindMatrixInverse } = mesh;
  if (!skinIndex || !skinWeight) return;
  skeleton.update();
  const bones = skeleton.boneMatrices!;
  const [matrix, linear, back] = [new Matrix4(), new Matrix3(), new Matrix3()];
  const vector = new Vector3();
  for (let v = 0; 3 * v < positions.length; v++) {
    if (v % CHUNK === CHUNK - 1) yield (3 * v) / positions.length;
    const { elements } = matrix;
    elements.fill(0);
    for (let i = 0; i < 4; i++) {
      const weight = skinWeight.getComponent(v, i);
      const bone = 16 * skinIndex.getComponent(v, i);
      if (weight !== 0) for (let k = 0; k < 16; k++) elements[k] += weight * bones[bone + k];
    }
    matrix.premultiply(bindMatrixInverse).multiply(bindMatrix);
    vector
      .fromArray(positions, 3 * v)
      .applyMatrix4(matrix)
      .toArray(positions as unknown as number[], 3 * v);
    linear.setFromMatrix4(matrix);
    if (normals)
      vector
        .fromArray(normals, 3 * v)
        .applyMatrix3(linear)
        .toArray(normals as unknown as number[], 3 * v);
    if (linear.determinant() === 0) continue;
    // Morph targets were applied first, so they are undone last.
    back.fromArray(toRest!, 9 * v).multiply(linear.invert());
    back.toArray(toRest as unknown as number[], 9 * v);
  }
}

/**
 * The smallest rotation from one direction to another, as in shaders/perFragment/rotationBetween.glsl; the identity for null vectors.
 * Normalises both.
 */
function rotationBetween(from: Vector3, to: Vector3): Matrix3 {
  const rotation = new Matrix3();
  const cosine = from.normalize().dot(to.normalize());
  // For opposite directions no axis is better than another.
  if (!(cosine > -0.999)) return rotation;
  const { x, y, z } = from.clone().cross(to);
  const scale = 1 / (1 + cosine);
  return rotation.set(
    1 - scale * (y * y + z * z),
    scale * x * y - z,
    scale * x * z + y,
    scale * x * y + z,
    1 - scale * (x * x + z * z),
    scale * y * z - x,
    scale * x * z - y,
    scale * y * z + x,
    1 - scale * (x * x + y * y),
  );
}
