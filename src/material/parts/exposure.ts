import type { Camera, Object3D, Scene, WebGLRenderer } from 'three';
import { ExposureFit, type PlanScene } from '../exposure/ExposureFit.js';
import type { ToneFit } from '../exposure/ToneFit.js';
import { FrameStamp } from '../FrameStamp.js';
import { fetchPlans, planCode } from './laterPlans.js';

interface Kept {
  readonly fit: ExposureFit;
  /** The frame of the last update. */
  readonly updated: FrameStamp;
}

/** Calls back with the code that plans values, at once or in a later frame. */
const withPlanner = (use: (planScene: PlanScene) => void): void => {
  const useCode = (): void => {
    const code = planCode();
    if (code) use(code);
  };
  if (planCode()) useCode();
  else fetchPlans().then(useCode);
};

/** Fits by the root of the scene. */
const kept = new WeakMap<Object3D, Kept>();

/** The fit of a scene that is being drawn. The scene is compared once per frame, and fitted again only if something has changed. */
export function sceneExposure(renderer: WebGLRenderer, scene: Scene, camera: Camera): ToneFit {
  let known = kept.get(scene);
  if (!known) {
    known = { fit: new ExposureFit(withPlanner), updated: new FrameStamp() };
    kept.set(scene, known);
  }
  if (known.updated.isOf(renderer, camera)) return known.fit.fit;
  known.updated.note(renderer, camera);
  return known.fit.update(scene, camera.layers.mask);
}

export { writeFit } from '../exposure/writeFit.js';
export { fetchPlansOf } from './laterPlans.js';
