import type { Object3D } from 'three';
import { mustBeAwaited } from '../material/diagnostics/warn.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { ApplyHatchingOptions } from '../scene/ApplyHatchingOptions.js';
import type { HatchedScene } from '../scene/HatchedScene.js';
import { hatchScene, type LookMakers } from '../scene/hatchScene.js';
import type { PresetName } from '../scene/presets.js';
import { HatchingNodeMaterial } from './HatchingNodeMaterial.js';
import type { HatchingOutlines } from './outlines/HatchingOutlines.js';

/** A scene that is hatched for WebGPURenderer. */
export type HatchedNodeScene = Omit<HatchedScene, 'materials' | 'outlines'> & {
  /** All new materials; you may change them. */
  readonly materials: readonly HatchingNodeMaterial[];
  /** The outlines of all meshes, if requested; you may change their materials. */
  readonly outlines: readonly HatchingOutlines[];
};

/** The options of `applyHatching` for WebGLRenderer, without the renderer: WebGPURenderer prepares its first frame itself. */
export type ApplyNodeHatchingOptions = Omit<ApplyHatchingOptions, 'renderer' | 'camera' | 'replaces'> & {
  /** An earlier result, whose meshes are hatched anew. */
  replaces?: HatchedNodeScene | undefined;
};

const OF_NODES = {
  material: () => new HatchingNodeMaterial(),
  fetchPartsOf: (material: HatchingNodeMaterial) => material.ready,
  outlineMaker: async (parameters: OutlineOptions & HatchingOutlineParameters) =>
    (await import('./outlines/outlinesOfNodes.js')).outlinesOfNodes(parameters),
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
  options: ApplyNodeHatchingOptions | PresetName = {},
): Promise<HatchedNodeScene> {
  // The shared code is typed by the classes of WebGLRenderer, and calls only these makers.
  const makers = OF_NODES as unknown as LookMakers;
  const hatched = hatchScene(root, options as ApplyHatchingOptions | PresetName, makers);
  return mustBeAwaited(hatched as unknown as Promise<HatchedNodeScene>, 'applyHatching()', [
    'materials',
    'outlines',
    'skipped',
    'restore',
    'dispose',
  ]);
}
