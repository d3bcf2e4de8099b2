import { DirectionalLight, PerspectiveCamera, Scene, type WebGLRenderer } from 'three';

/** A scene with a sun, and a camera, for a model with a bounding radius of 1. */
export function litScene(): { scene: Scene; camera: PerspectiveCamera; sun: DirectionalLight } {
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(0, 0.3, 3.2);
  camera.lookAt(0, 0, 0);
  return { scene: new Scene().add(sun), camera, sun };
}

/** Has the sun of a lit scene cast the shadow of such a model, and a renderer draw it. */
export function castShadow(renderer: WebGLRenderer, sun: DirectionalLight): void {
  renderer.shadowMap.enabled = true;
  sun.castShadow = true;
  sun.shadow.mapSize.setScalar(1024);
  Object.assign(sun.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.1, far: 5 });
  sun.shadow.bias = -0.002;
  sun.shadow.normalBias = 0.02;
}
