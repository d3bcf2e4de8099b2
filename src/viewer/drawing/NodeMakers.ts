import type { Mesh } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import type { HatchingNodeMaterial, HatchingOutlineNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';

/** A material for either renderer; both kinds have the same properties. */
export type EitherMaterial = HatchingMaterial | HatchingNodeMaterial;

/** Creates what WebGPURenderer needs to draw a model. This room imports only types, so that the renderer is loaded on demand. */
export interface NodeMakers {
  /** A node material that looks like a material for WebGLRenderer. */
  material(like: HatchingMaterial): HatchingNodeMaterial;
  outlineMaterial(): HatchingOutlineNodeMaterial;
  outlines(mesh: Mesh | null, material: HatchingOutlineNodeMaterial): HatchingOutlines;
}
