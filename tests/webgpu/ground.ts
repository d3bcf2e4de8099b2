import {
  type Light,
  type LightShadow,
  type Material,
  Mesh,
  PlaneGeometry,
  PointLight,
  SpotLight,
  type Vector3Tuple,
} from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { type KnotStage, knot, shadowed } from './knot.js';
import type { Kit } from './SceneCase.js';

/** A light that casts shadows. */
export type Casting = Light & { shadow: LightShadow };

function casting<Shining extends Casting>(light: Shining, ...[x, y, z]: Vector3Tuple): Shining {
  light.position.set(x, y, z);
  light.castShadow = true;
  Object.assign(light.shadow.camera, { near: 0.3, far: 12 });
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.02;
  return light;
}

/** A knot that casts its shadow on a ground. @param ground the ground's material; by default that of the knot */
export async function onGround(
  kit: Kit,
  parameters: HatchingMaterialParameters,
  ground: Material | null = null,
): Promise<KnotStage> {
  const stage = shadowed(knot(await kit.hatching(parameters)));
  stage.mesh.scale.setScalar(0.7);
  const { camera } = stage.sun.shadow;
  Object.assign(camera, { left: -2, right: 2, top: 2, bottom: -2 });
  stage.sun.position.set(2.2, 2.4, 0.4);
  const floor = new Mesh(new PlaneGeometry(4, 4), ground ?? stage.mesh.material);
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -0.75;
  floor.receiveShadow = true;
  stage.scene.add(floor);
  stage.camera.position.set(0.6, 1.6, 3.8);
  stage.camera.lookAt(0, -0.2, 0);
  return stage;
}

export const lamp = (): PointLight => casting(new PointLight(0xffffff, 1, 0, 0), -1.5, 1.6, 1.2);
export const spot = (): SpotLight => casting(new SpotLight(0xffffff, 1.2, 0, 0.6, 0.3, 0), -1.8, 2.4, 1.6);
