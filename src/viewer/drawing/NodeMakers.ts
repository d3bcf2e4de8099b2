import type { Mesh } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import type { HatchingNodeMaterial, HatchingOutlineNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';

/** A material of either renderer: both have the same properties. */
export type EitherMaterial = HatchingMaterial | HatchingNodeMaterial;

/** Makes what WebGPURenderer draws a model with. Whoever has it has fetched that renderer; this room knows only the types. */
export interface NodeMakers {
  /** A material with the look of another, which draws with WebGLRenderer. */
  material(like: HatchingMaterial): HatchingNodeMaterial;
  outlineMaterial(): HatchingOutlineNodeMaterial;
  outlines(mesh: Mesh | null, material: HatchingOutlineNodeMaterial): HatchingOutlines;
}
