import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import { isFitted } from '../material/exposure/isFitted.js';
import { writeFit } from '../material/exposure/ToneFit.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { Later } from './Later.js';

const fitting = /* @__PURE__ */ new Later(
  'fits an exposure',
  'the exposure is 1',
  () => import('../material/exposure/sceneExposure.js'),
);

/** Resolves when the code that fits a material's exposure is loaded, or is not needed. */
export const exposureReady = async (material: HatchingMaterialProperties): Promise<void> => {
  if (isFitted(material)) await fitting.fetch();
};

/** Writes the exposure that suits the scene if `exposure` is fitted, once the code is loaded. */
export function writeExposure(
  material: HatchingMaterialProperties,
  renderer: WebGLRenderer,
  scene: Scene,
  camera: Camera,
  uniforms: Record<string, IUniform>,
): void {
  if (!isFitted(material)) return;
  const { code } = fitting;
  if (code) writeFit(code.sceneExposure(renderer, scene, camera), material, uniforms);
  else fitting.ask();
}
