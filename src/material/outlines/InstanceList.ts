import {
  DataTexture,
  FloatType,
  type InstancedMesh,
  Matrix3,
  RGBAFormat,
  RGBAIntegerFormat,
  UnsignedIntType,
  Vector3,
  Vector4,
} from 'three';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';
import { findCandidates } from '../../mesh/features/contourCandidates.js';
import type { OutlineData } from '../geometry/OutlineData.js';
import { eyeDistance } from './ContourList.js';

/** The sine of the angle through which the direction from an instance to the eye may turn before a new list is needed. */
const SINE = Math.sin((3 * Math.PI) / 180);
/**
 * The greatest number of primitives, of all instances together, that are searched. A million take about ten milliseconds; more would
 * block the page.
 */
export const MAX_SEARCHED = 4_000_000;
/** Words per entry of the list: the index of a primitive and that of its instance. */
const PAIR_WORDS = 2;
/** Texels per matrix in the texture of matrices. */
const MATRIX_TEXELS = 4;

const inverse = /* @__PURE__ */ new Matrix3();
const place = /* @__PURE__ */ new Vector3();

/**
 * A list of the primitives of all instances of a mesh that may hold an outline, as seen by one camera. A GPU tests every primitive
 * faster than this search, so the search runs only before the first frame and when the eye rests. For a software rasterizer the search
 * takes a small part of the time of those tests.
 */
export class InstanceList {
  /** Pairs of a primitive and an instance, two per texel. */
  texture: DataTexture | null = null;
  /** The matrices of the instances, a column per texel. */
  places: DataTexture | null = null;
  /** The number of pairs. */
  count = 0;
  private data: OutlineData | null = null;
  private readonly seen = new View();
  private readonly listed = new View();
  /**
   * The distance that the eye may move before the list is out of date, in the object space of the mesh; negative if there is no list.
   */
  private reach = -1;

  /**
   * Updates the list.
   *
   * @param eye the eye in the object space of the mesh; for an orthographic camera w is 0 and xyz the direction to it
   * @returns whether the list is valid for this eye. If not, every primitive of every instance must be tested.
   */
  update(data: OutlineData, mesh: InstancedMesh, eye: Vector4): boolean {
    const isFirst = this.data !== data;
    const isResting = isFirst || this.seen.distanceTo(mesh, eye) === 0;
    this.seen.set(mesh, eye);
    if (isFirst) {
      this.data = data;
      this.reach = -1;
    }
    if (this.listed.distanceTo(mesh, eye) <= this.reach) return true;
    const primitives = data.triangleCount + data.edgeCount;
    if (!isResting || !data.search || primitives * mesh.count > MAX_SEARCHED) return false;
    this.listed.set(mesh, eye);
    this.search(data, mesh, eye);
    return true;
  }

  dispose(): void {
    this.texture?.dispose();
    this.places?.dispose();
    this.texture = this.places = null;
    this.data = null;
    this.reach = -1;
  }

  private search(data: OutlineData, mesh: InstancedMesh, eye: Vector4): void {
    const search = data.search!;
    const all = data.triangleCount + data.edgeCount;
    const matrices = mesh.instanceMatrix.array;
    const { boundingSphere } = mesh.geometry;
    const radius = boundingSphere?.radius ?? Infinity;
    let pairs = new Uint32Array(PAIR_WORDS * all);
    let words = 0;
    let reach = eye.w === 0 ? 0 : Infinity;
    for (let instance = 0; instance < mesh.count; instance++) {
      const m = MATRIX_TEXELS * 4 * instance;
      inverse.set(
        matrices[m],
        matrices[m + 4],
        matrices[m + 8],
        matrices[m + 1],
        matrices[m + 5],
        matrices[m + 9],
        matrices[m + 2],
        matrices[m + 6],
        matrices[m + 10],
      );
      inverse.invert();
      place.set(eye.x - eye.w * matrices[m + 12], eye.y - eye.w * matrices[m + 13], eye.z - eye.w * matrices[m + 14]);
      place.applyMatrix3(inverse);
      const room = boundingSphere ? place.distanceTo(boundingSphere.center) - radius : 0;
      let count = all;
      // All primitives of an instance that is near or flat are listed: a list for it would be out of date after any movement.
      const isListed = eye.w === 0 ? place.length() > 0 : room > radius;
      if (isListed) {
        if (eye.w === 0) place.normalize();
        else reach = Math.min(reach, (SINE * room) / normOf(inverse));
        count = findCandidates(search, [place.x, place.y, place.z, eye.w], SINE);
      }
      if (words + PAIR_WORDS * count > pairs.length) {
        const grown = new Uint32Array(2 * pairs.length + PAIR_WORDS * count);
        grown.set(pairs);
        pairs = grown;
      }
      for (let i = 0; i < count; i++) {
        pairs[words++] = isListed ? search.list[i] : i;
        pairs[words++] = instance;
      }
    }
    this.count = words / PAIR_WORDS;
    this.reach = reach;
    this.texture?.dispose();
    this.places?.dispose();
    this.texture = textureOf(pairs, words, Uint32Array, RGBAIntegerFormat, UnsignedIntType);
    this.places = textureOf(matrices, 4 * MATRIX_TEXELS * mesh.count, Float32Array, RGBAFormat, FloatType);
  }
}

/** The eye and the instances of a frame. */
class View {
  private matrices: object | null = null;
  private version = -1;
  private count = -1;
  private readonly eye = new Vector4();

  set({ instanceMatrix, count }: InstancedMesh, eye: Vector4): void {
    this.matrices = instanceMatrix;
    this.version = instanceMatrix.version;
    this.count = count;
    this.eye.copy(eye);
  }

  /** The distance that the eye has moved; infinite if the instances have changed. */
  distanceTo({ instanceMatrix, count }: InstancedMesh, eye: Vector4): number {
    const isSame = instanceMatrix === this.matrices && instanceMatrix.version === this.version && count === this.count;
    return isSame ? eyeDistance(this.eye, eye) : Infinity;
  }
}

/** The Frobenius norm of a matrix: an upper bound for the factor by which it stretches. */
const normOf = ({ elements }: Matrix3): number => Math.sqrt(elements.reduce((sum, element) => sum + element ** 2, 0));

function textureOf(
  from: ArrayLike<number>,
  length: number,
  Words: typeof Uint32Array | typeof Float32Array,
  ...format: [format: typeof RGBAFormat | typeof RGBAIntegerFormat, type: typeof FloatType | typeof UnsignedIntType]
): DataTexture {
  const { width, height } = pullTextureSize(Math.max(1, Math.ceil(length / 4)));
  const words = new Words(4 * width * height);
  for (let i = 0; i < length; i++) words[i] = from[i];
  const texture = new DataTexture(words as Float32Array<ArrayBuffer>, width, height, ...format);
  texture.needsUpdate = true;
  return texture;
}
