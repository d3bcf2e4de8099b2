import type { Camera, Mesh, RenderTarget } from 'three';

/** What draws the vertices of one geometry, in the poses of its meshes, into textures of a texel per vertex. */
export interface PosePass {
  makeTarget(): RenderTarget;
  /** Draws the pose of a mesh while its renderer draws it for `camera`. Leaves the renderer's state as it was. */
  draw(target: RenderTarget, camera: Camera, mesh: Mesh): void;
  /** Builds the program that a mesh needs, and draws nothing. */
  compile?(target: RenderTarget, mesh: Mesh): void;
  dispose(): void;
}
