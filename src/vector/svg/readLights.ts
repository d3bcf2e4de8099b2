import {
  type Camera,
  type DirectionalLight,
  type Light,
  type LightShadow,
  MathUtils,
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  type PointLight,
  type SpotLight,
  Vector3,
} from 'three';
import type { Surroundings } from '../../look/surroundings.js';
import { luminanceOf, type Vec3 } from '../../look/vectors.js';
import { LightsAround } from '../../material/exposure/LightsAround.js';
import type { LampShadow } from '../ShadowRays.js';
import type { Lamp } from '../shading/radiance.js';

const placeOf = ({ matrixWorld }: Object3D): Vec3 => new Vector3().setFromMatrixPosition(matrixWorld).toArray();

/** The unit vector from one object to another. */
const wayBetween = (from: Object3D, to: Object3D): Vec3 =>
  new Vector3(...placeOf(to))
    .sub(new Vector3(...placeOf(from)))
    .normalize()
    .toArray();

/** The lights of a scene that a camera sees. */
export interface SceneLights {
  lamps: Lamp[];
  /** The shadow of each lamp; null for none. */
  shadows: (LampShadow | null)[];
  around: Surroundings;
}

/** @param shadows whether lights with `castShadow` cast shadows */
export function readLights(scene: Object3D, camera: Camera, shadows: boolean): SceneLights {
  const lamps: Lamp[] = [];
  const castShadows: (LampShadow | null)[] = [];
  const others: Light[] = [];
  scene.traverseVisible((object) => {
    if (!('isLight' in object) || !object.layers.test(camera.layers)) return;
    const lamp = lampOf(object as Light, shadows);
    if (lamp) {
      lamps.push(lamp);
      castShadows.push(readLampShadow(object as Light));
    } else others.push(object as Light);
  });
  return { lamps, shadows: castShadows, around: new LightsAround({ lights: others, scene }).surroundings };
}

/** A light with a direction as a lamp; undefined for others. */
function lampOf(light: Light, shadows: boolean): Lamp | undefined {
  const sent = light.intensity * luminanceOf(light.color);
  const castsShadow = shadows && light.castShadow;
  const lamp = { luminance: sent, at: placeOf(light), castsShadow, distance: 0, decay: 0, cone: null };
  if ('isDirectionalLight' in light) {
    return { ...lamp, at: wayBetween((light as DirectionalLight).target, light), isFar: true };
  }
  if (!('isPointLight' in light || 'isSpotLight' in light)) return undefined;
  const { distance, decay } = light as PointLight;
  if (!('isSpotLight' in light)) return { ...lamp, isFar: false, distance, decay };
  const { angle, penumbra, target } = light as unknown as SpotLight;
  const cone = {
    axis: wayBetween(target, light as unknown as SpotLight),
    outer: Math.cos(angle),
    inner: Math.cos(angle * (1 - penumbra)),
  };
  return { ...lamp, isFar: false, distance, decay, cone };
}

/** The shadow map of a light on the canvas; null for lights without shadows. */
function readLampShadow(light: Light): LampShadow | null {
  const { shadow } = light as { shadow?: LightShadow };
  if (!shadow?.camera) return null;
  const { mapSize, radius } = shadow;
  return {
    texels: Math.max(mapSize.x, 1),
    radius: Math.max(radius, 0),
    intensity: shadow.intensity ?? 1,
    isCube: 'isPointLight' in light,
    width: widthOf(light, shadow.camera as OrthographicCamera | PerspectiveCamera),
  };
}

function widthOf(light: Light, camera: OrthographicCamera | PerspectiveCamera): number {
  if ('isOrthographicCamera' in camera) return (camera.right - camera.left) / (camera.zoom || 1);
  if (!('isSpotLight' in light)) return 2;
  const { angle, shadow } = light as SpotLight;
  // three.js derives the shadow camera of a spot light from its angle.
  return 2 * Math.tan(Math.min(angle * shadow.focus, MathUtils.degToRad(89)));
}
