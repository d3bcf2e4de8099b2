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

export interface KnotStage extends Stage {
  camera: PerspectiveCamera;
  mesh: Mesh;
  sun: DirectionalLight;
}

/** A knot under the sun and ambient light. */
export function knot(material: Material): KnotStage {
  const camera = new PerspectiveCamera(30, 1, 0.1, 20);
  camera.position.set(0.6, 0.3, 4);
  camera.lookAt(0, 0, 0);
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.set(1.6, 2.2, 2.4);
  const mesh = new Mesh(new TorusKnotGeometry(0.62, 0.24, 96, 20), material);
  const scene = new Scene().add(sun, new AmbientLight(0xffffff, 0.6), mesh);
  return { scene, camera, mesh, sun };
}

/** The same knot, which casts shadows on itself. */
export function shadowed<Shown extends KnotStage>(stage: Shown): Shown {
  stage.mesh.castShadow = stage.mesh.receiveShadow = stage.sun.castShadow = true;
  Object.assign(stage.sun.shadow.camera, { left: -1.2, right: 1.2, top: 1.2, bottom: -1.2, near: 0.1, far: 10 });
  stage.sun.shadow.bias = -0.0005;
  stage.sun.shadow.normalBias = 0.02;
  return stage;
}
