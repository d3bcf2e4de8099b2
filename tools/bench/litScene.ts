import { DirectionalLight, PerspectiveCamera, Scene } from 'three';

/** A scene with a sun, and a camera, for a model with a bounding radius of 1. */
export function litScene(): { scene: Scene; camera: PerspectiveCamera; sun: DirectionalLight } {
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(1, 1, 1);
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(0, 0.3, 3.2);
  camera.lookAt(0, 0, 0);
  return { scene: new Scene().add(sun), camera, sun };
}
