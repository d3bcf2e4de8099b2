import type { Object3D } from 'three';
import { ExposureFit } from '../material/exposure/ExposureFit.js';
import { planScene } from '../material/exposure/planScene.js';
import type { ToneFit } from '../material/exposure/ToneFit.js';
import { assertTree } from './assertTree.js';

/**
 * Computes the exposure that materials with an `exposure` of `'fit'` or `'auto'` would have if it were fitted to a scene now: the light
 * that a white surface reflects is multiplied by `scale`, `offset` is added, and 1 is blank paper. Materials compute the same exposure
 * themselves; call this to know it.
 *
 * The bright and the dark parts of the surfaces, by their area, get the radiance of those of a sphere in a single light of intensity π.
 * If colours become tones, `plan` has the darkness that each is drawn with; and where they are measured instead, `white` is the lightness at
 * and above which they are left blank: that of the lightest tenth.
 *
 * - Meshes count that are visible and have a `HatchingMaterial` with an `exposure` of `'fit'` or `'auto'`, and flat ones, such as a ground,
 * only where there are no others. Skins and morph targets are at rest, of instances some are looked at, and batches are left out.
 * - Lights, environment and light probes of the scene count, with occlusion that `bakeOcclusion` has baked. Shadows and maps do not. An
 * environment that is on the GPU only, such as the result of `PMREMGenerator`, counts as three's `RoomEnvironment`.
 * - The result depends on the scene alone, not on a camera, a picture or earlier frames, and needs no browser.
 *
 * @param scene lights and meshes at or below it
 * @throws TypeError for anything else than an object
 * @throws Error if the object is its own descendant
 */
export function fitExposure(scene: Object3D): ToneFit {
  if (!scene?.isObject3D) throw new TypeError('fitExposure: expected a THREE.Object3D, such as a scene.');
  assertTree('fitExposure', scene);
  scene.updateWorldMatrix(true, false);
  scene.updateMatrixWorld();
  return { ...new ExposureFit((use) => use(planScene)).update(scene, ALL_LAYERS) };
}

const ALL_LAYERS = 0xffffffff | 0;
