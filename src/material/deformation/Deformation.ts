import type { Camera, Material, Mesh, RenderTarget, Texture } from 'three';
import { Pose } from './Pose.js';

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
