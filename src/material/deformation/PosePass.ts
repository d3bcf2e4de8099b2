import type { Camera, Mesh, RenderTarget } from 'three';

/** Draws the vertices of one geometry, in the poses of its meshes, into textures with one texel per vertex. */
export interface PosePass {
  makeTarget(): RenderTarget;
  /** Draws the pose of a mesh while its renderer draws it for `camera`. Restores the renderer's state. */
  draw(target: RenderTarget, camera: Camera, mesh: Mesh): void;
  /** Builds the program that a mesh needs, without drawing. */
  compile?(target: RenderTarget, mesh: Mesh): void;
  dispose(): void;
}
