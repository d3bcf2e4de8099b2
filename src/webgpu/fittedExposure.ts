import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import { isFitted } from '../material/exposure/isFitted.js';
import { writeFit } from '../material/exposure/writeFit.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';

type Fitting = typeof import('../material/exposure/sceneExposure.js');

let fetched: Fitting | undefined;
let fetching: Promise<void> | undefined;

/** Fetches the code that fits an exposure, once. If that fails, it says so, and the next call tries again. @throws Error that says so */
function fetchFitting(): Promise<void> {
  fetching ??= import('../material/exposure/sceneExposure.js').then(
    (fitting) => {
      fetched = fitting;
    },
    (cause: unknown) => {
      fetching = undefined;
      const message =
        'HatchingNodeMaterial: the code that fits an exposure could not be fetched; the exposure is 1. Serve all files of the package; the next frame, or "ready", tries again.';
      console.error(message);
      throw new Error(message, { cause });
    },
  );
  return fetching;
}

/** Resolves when the exposure of a material can be fitted, or need not be. */
export const exposureReady = async (material: HatchingMaterialProperties): Promise<void> => {
  if (isFitted(material)) await fetchFitting();
};

/** Writes the exposure that suits the scene, where it is fitted to that, as soon as the code is there. */
export function writeExposure(
  material: HatchingMaterialProperties,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  uniforms: Record<string, IUniform>,
): void {
  if (!isFitted(material)) return;
  if (fetched) writeFit(fetched.sceneExposure(renderer, scene, camera), material, uniforms);
  // The failure is told of where it happens.
  else fetchFitting().catch(() => {});
}
