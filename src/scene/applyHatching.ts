import type { Object3D } from 'three';
import { HATCHING_DEFAULTS } from '../look/hatchingProperties.js';
import { spelledOut } from '../look/presetParameters.js';
import { mustBeAwaited } from '../material/diagnostics/warn.js';
import { HatchingMaterial } from '../material/HatchingMaterial.js';
import { fetchPartsOf } from '../material/parts/parts.js';
import type { ApplyHatchingOptions, HatchingPreset } from './ApplyHatchingOptions.js';
import type { HatchedScene } from './HatchedScene.js';
import { hatchScene, type LookMakers } from './hatchScene.js';
import type { PresetName } from './presets.js';

/** Properties of the result that users read first. */
const FIRST_READ = ['materials', 'outlines', 'skipped', 'update', 'setPreset', 'restore', 'dispose'] as const;

const fetchOutlines = () => import('./outlinesInGlsl.js');

const IN_GLSL: LookMakers = {
  material: () => new HatchingMaterial(),
  fetchAhead: async ({ material, outlines }) =>
    Promise.all([
      outlines && fetchOutlines(),
      typeof material !== 'function' && fetchPartsOf({ ...HATCHING_DEFAULTS, ...spelledOut(material ?? {}) }),
    ]),
  fetchPartsOf,
  async outlineMaker(parameters) {
    return (await fetchOutlines()).outlinesInGlsl(parameters);
  },
};

/**
 * Hatches a whole scene, such as a loaded glTF. The geometry of every mesh at or below `root` is baked, a shared geometry only
 * once. Every material is replaced by a `HatchingMaterial` with the same colour, maps, opacity, sides and vertex colours.
 * Instances, groups, skins and morph targets keep working; lines, points and sprites are left alone. The scene does not change
 * before everything is ready, and not at all if that fails or is aborted. After an abort it can be hatched again at once.
 *
 *     const hatched = await applyHatching(gltf.scene, 'pencil', { signal });
 *
 * The result is the handle of the scene: `update()` hatches what was added and releases what is gone, `setPreset()` gives it another
 * look in place, `release()` gives a part back, `dispose()` all of it. Of two calls under way for one root the later wins: the earlier is
 * rejected with an `AbortError`. Changes of the scene's own materials count in the next frame.
 *
 * With the options `renderer` and `camera` the promise also waits for the programs and the upload, so that the first frame is
 * drawn at once: add `root` and the lights to the scene before. Without them call `renderer.compileAsync(scene, camera)` afterwards.
 *
 * - A material that meshes share becomes one shared material. If the meshes differ in scale, there is one material per scale,
 * because `tilesPerObjectUnit` refers to object space. Meshes that deform get a material of their own.
 * - Meshes that already have a `HatchingMaterial` are left alone.
 * - `skipped` lists the meshes that were left alone, each with the reason: those whose material is a `ShaderMaterial`, has an
 * `onBeforeCompile` of its own or shows a render target, as helpers such as grids, mirrors, text and contact shadows do; those with
 * `userData.hatching` set to false, on the mesh or on the nearest ancestor that has the property (true hatches the mesh whatever its
 * material is); those that another call has hatched; and, with an `error`, those whose geometry cannot be baked or whose geometry or
 * material was replaced during the call. Meshes that are hatched without the requested outlines are listed too.
 * - If there is no mesh to hatch, one warning says so, and the result is empty until `update()` finds something.
 * - Lines continue from mesh to mesh: `userData.hatchingField` of each mesh holds the coordinate frame that they
 * share, as it is at the time of the call. Clones keep it. Instances and batches have separate lines. Lines that follow the form
 * continue where the borders of meshes meet.
 * - Geometries that `triangle` or `adjacency` draws are baked with adjacency, the others without, unless `adjacency` requests it.
 * No map is drawn for materials that need none.
 * - `outlines` draws contours, borders and creases of every mesh except `BatchedMesh`, and cut-outs that are blended or write no depth.
 * - A `BatchedMesh` keeps its geometry. Most techniques hatch it with the normals that it has; `triangle` and `adjacency` can draw it only if
 * it was filled with prepared geometries.
 *
 * The promise is rejected
 *
 * - with an `AbortError` if another call for the same root begins;
 * - with an Error if an object is its own descendant;
 * - with a RangeError for an unknown preset or an option out of its range, and with a TypeError for an unknown option;
 * - with a TypeError that names the first meshes, if none of those that were to be hatched could be; its `cause` is the first error;
 * - with the error of the map or of a parameter;
 * - with the signal's reason when aborted.
 *
 * @param look a preset, by its name or as an object, or options
 * @param options further options, which override those of `look`
 */
export function applyHatching(
  root: Object3D,
  look: PresetName | HatchingPreset | ApplyHatchingOptions = {},
  options: ApplyHatchingOptions = {},
): Promise<HatchedScene> {
  return mustBeAwaited(hatchScene(IN_GLSL, root, look, options), 'applyHatching()', FIRST_READ);
}
