import type { Material, RenderTarget, Texture } from 'three';
import { Pose } from './Pose.js';

/** Positions, normals and rotations of the vertices of a geometry in one pose: a texel each, on one graphics context. */
export class Deformation {
  /** The pose that its textures hold. */
  readonly pose: Pose = new Pose();
  /** How many meshes are in this pose, and draw with it. */
  holders = 0;
  /** The materials that meshes were drawn with in this pose. */
  readonly users: Set<Material> = new Set();
  isDisposed = false;

  constructor(readonly target: RenderTarget) {}

  /** x, y, z of each vertex as drawn, in object space. */
  get positions(): Texture {
    return this.target.textures[0];
  }

  /** x, y, z of each vertex's normal as drawn, in object space, not of unit length. */
  get normals(): Texture {
    return this.target.textures[1];
  }

  /** The rotation of each vertex by its skin, as a quaternion; zero where morph targets move it too. */
  get turns(): Texture {
    return this.target.textures[2];
  }

  dispose(): void {
    this.isDisposed = true;
    this.target.dispose();
  }
}
