import type { Camera, Material, Mesh, RenderTarget, SkinnedMesh, Texture } from 'three';

/** The numbers that deform a mesh: morph target influences, bone matrices and bind matrices. */
export class Pose {
  private numbers = new Float32Array(0);
  private length = -1;
  private hasChanged = true;

  /** Copies the pose of `mesh`. Returns whether it differs from the previous one. Allocates only if the pose has grown. */
  update(mesh: Mesh): boolean {
    const length = this.length;
    this.length = 0;
    this.hasChanged = false;
    if (mesh.morphTargetInfluences) this.add(mesh.morphTargetInfluences);
    if ('isSkinnedMesh' in mesh) {
      const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
      if (skeleton.boneMatrices) this.add(skeleton.boneMatrices);
      this.add(bindMatrix.elements);
      this.add(bindMatrixInverse.elements);
    }
    return this.hasChanged || this.length !== length;
  }

  /** Whether these influences are the whole pose, as of a mesh without a skin. */
  isOf(influences: ArrayLike<number>): boolean {
    if (this.length !== influences.length) return false;
    for (let i = 0; i < influences.length; i++) if (this.numbers[i] !== Math.fround(influences[i])) return false;
    return true;
  }

  /** The hash of the influences: the key of the pose of a mesh without a skin. See {@link hashOf}. */
  get influenceHash(): number {
    return hashOf(this.numbers, Math.max(this.length, 0));
  }

  private add(numbers: ArrayLike<number>): void {
    const start = this.length;
    this.length += numbers.length;
    if (this.length > this.numbers.length) {
      const grown = new Float32Array(this.length);
      grown.set(this.numbers);
      this.numbers = grown;
      this.hasChanged = true;
    }
    for (let i = 0; i < numbers.length; i++) {
      const number = Math.fround(numbers[i]);
      if (this.numbers[start + i] === number) continue;
      this.numbers[start + i] = number;
      this.hasChanged = true;
    }
  }
}

/** Reads the bits of a number. Bundlers can drop an unused DataView, but not two typed arrays on one buffer. */
const bits = /* @__PURE__ */ new DataView(/* @__PURE__ */ new ArrayBuffer(4));
/** The largest integers that engines store without allocating have 30 bits. */
const HASH_BITS = 0x3fffffff;

/** A hash of influences: equal for equal influences, and rarely equal for others. Allocates nothing. */
export function hashOf(influences: ArrayLike<number>, length: number = influences.length): number {
  let hash = length;
  for (let i = 0; i < length; i++) {
    // Adding 0 turns −0 into 0, since the two are equal.
    bits.setFloat32(0, influences[i] + 0);
    hash = Math.imul(hash ^ bits.getInt32(0), 0x01000193);
    hash ^= hash >>> 15;
  }
  return hash & HASH_BITS;
}

/** Positions, normals and rotations of a geometry's vertices in one pose: one texel each, on one graphics context. */
export class Deformation {
  /** The pose in the textures. */
  readonly pose: Pose = new Pose();
  /** The number of meshes that are in this pose and drawn with these textures. */
  holders = 0;
  /** The materials that have drawn meshes with these textures. */
  readonly users: Set<Material> = new Set();
  isDisposed = false;

  constructor(readonly target: RenderTarget) {}

  /** x, y, z of each deformed vertex, in object space. */
  get positions(): Texture {
    return this.target.textures[0];
  }

  /** x, y, z of each deformed vertex normal, in object space, not of unit length. */
  get normals(): Texture {
    return this.target.textures[1];
  }

  /** The rotation of each vertex by its skin, as a quaternion; zero where morph targets move the vertex too. */
  get turns(): Texture {
    return this.target.textures[2];
  }

  dispose(): void {
    this.isDisposed = true;
    this.target.dispose();
  }
}

/** Draws the vertices of one geometry, in the poses of its meshes, into textures with one texel per vertex. */
export interface PosePass {
  makeTarget(): RenderTarget;
  /** Draws the pose of a mesh while its renderer draws it for `camera`. Restores the renderer's state. */
  draw(target: RenderTarget, camera: Camera, mesh: Mesh): void;
  /** Builds the program that a mesh needs, without drawing. */
  compile?(target: RenderTarget, mesh: Mesh): void;
  dispose(): void;
}
