import {
  AmbientLight,
  DirectionalLight,
  type Material,
  Mesh,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
} from 'three';
import type { Stage } from './SceneCase.js';

/** A knot under the sun, somewhat lightened. */
export function knot(material: Material): Stage & { camera: PerspectiveCamera; mesh: Mesh; sun: DirectionalLight } {
  const camera = new PerspectiveCamera(30, 1, 0.1, 20);
  camera.position.set(0.6, 0.3, 4);
  camera.lookAt(0, 0, 0);
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.set(1.6, 2.2, 2.4);
  const mesh = new Mesh(new TorusKnotGeometry(0.62, 0.24, 96, 20), material);
  const scene = new Scene().add(sun, new AmbientLight(0xffffff, 0.6), mesh);
  return { scene, camera, mesh, sun };
}
