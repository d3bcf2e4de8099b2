import type { Material, Mesh, Object3D } from 'three';
import { mustBeAwaited } from '../material/diagnostics/warn.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { ApplyHatchingOptions, HatchingPreset } from '../scene/ApplyHatchingOptions.js';
import type { HatchedScene, HatchingTask } from '../scene/HatchedScene.js';
import { hatchScene, type LookMakers } from '../scene/hatchScene.js';
import type { PresetName } from '../scene/presets.js';
import { HatchingNodeMaterial } from './HatchingNodeMaterial.js';
import type { HatchingOutlines } from './outlines/HatchingOutlines.js';

/** A scene that is hatched for WebGPURenderer. */
export type HatchedNodeScene = Omit<
  HatchedScene,
  'materials' | 'outlines' | 'materialOf' | 'outlineOf' | 'update' | 'setPreset'
> & {
  /** All new materials; you may change them. */
  readonly materials: readonly HatchingNodeMaterial[];
  /** The outlines of all meshes, if requested; you may change their materials. */
  readonly outlines: readonly HatchingOutlines[];
  /** The material that a mesh is hatched with, or the materials in the order of its own; undefined if the mesh is not hatched. */
  materialOf(mesh: Mesh): HatchingNodeMaterial | (HatchingNodeMaterial | Material)[] | undefined;
  /** The outlines of a mesh; undefined if it has none. */
  outlineOf(mesh: Mesh): HatchingOutlines | undefined;
  /** Hatches what was added, and releases what is gone, as `HatchedScene.update` does. */
  update(task?: HatchingTask): Promise<HatchedNodeScene>;
  /** Gives the scene another look, in place, as `HatchedScene.setPreset` does. */
  setPreset(
    look: PresetName | HatchingPreset | ApplyNodeHatchingOptions,
    options?: ApplyNodeHatchingOptions,
  ): Promise<HatchedNodeScene>;
};

/** The options of `applyHatching` for WebGLRenderer, without the renderer: WebGPURenderer prepares its first frame itself. */
export type ApplyNodeHatchingOptions = Omit<ApplyHatchingOptions, 'renderer' | 'camera'>;

/** Properties of the result that users read first. */
const FIRST_READ = ['materials', 'outlines', 'skipped', 'update', 'setPreset', 'restore', 'dispose'] as const;

const fetchOutlines = () => import('./outlines/outlinesOfNodes.js');

const OF_NODES = {
  material: () => new HatchingNodeMaterial(),
  // The nodes of a material are loaded with the material.
  fetchAhead: async ({ outlines }: ApplyHatchingOptions) => outlines && fetchOutlines(),
  fetchPartsOf: (material: HatchingNodeMaterial) => material.ready,
  outlineMaker: async (parameters: OutlineOptions & HatchingOutlineParameters) =>
    (await fetchOutlines()).outlinesOfNodes(parameters),
};

/**
 * Hatches a whole scene for WebGPURenderer, as `applyHatching` of `three-hatching` does for WebGLRenderer: the same presets, options and
 * results, with a `HatchingNodeMaterial` in place of every material. The promise is rejected for the same reasons.
 *
 *     await applyHatching(gltf.scene, 'engraving');
 *     await renderer.compileAsync(scene, camera);
 */
export function applyHatching(
  root: Object3D,
  look: PresetName | HatchingPreset | ApplyNodeHatchingOptions = {},
  options: ApplyNodeHatchingOptions = {},
): Promise<HatchedNodeScene> {
  // The shared code is typed by the classes of WebGLRenderer, and calls only these makers.
  const makers = OF_NODES as unknown as LookMakers;
  const hatched = hatchScene(makers, root, look, options);
  return mustBeAwaited(hatched as unknown as Promise<HatchedNodeScene>, 'applyHatching()', FIRST_READ);
}
