import type { Camera, Object3D, Scene, WebGLRenderer } from 'three';
import { ExposureFit } from '../exposure/ExposureFit.js';
import type { ToneFit } from '../exposure/ToneFit.js';
import { FrameStamp } from '../FrameStamp.js';

interface Kept {
  readonly fit: ExposureFit;
  /** The frame of the last update. */
  readonly updated: FrameStamp;
}

/** Fits by the root of the scene. */
const kept = new WeakMap<Object3D, Kept>();

/** The fit of a scene that is being drawn. The scene is compared once per frame, and fitted again only if something has changed. */
export function sceneExposure(renderer: WebGLRenderer, scene: Scene, camera: Camera): ToneFit {
  let known = kept.get(scene);
  if (!known) {
    known = { fit: new ExposureFit(), updated: new FrameStamp() };
    kept.set(scene, known);
  }
  if (known.updated.isOf(renderer, camera)) return known.fit.fit;
  known.updated.note(renderer, camera);
  return known.fit.update(scene, camera.layers.mask);
}
