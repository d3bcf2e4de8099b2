import {
  type Light,
  type LightShadow,
  MathUtils,
  type OrthographicCamera,
  type PerspectiveCamera,
  type SpotLight,
} from 'three';
import type { LampShadow } from '../ShadowRays.js';

/** What the shadow of a light is read from on the canvas; null for lights that cast none. */
export function readLampShadow(light: Light): LampShadow | null {
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
  // Renderers set the camera of a spot by its angle.
  return 2 * Math.tan(Math.min(angle * shadow.focus, MathUtils.degToRad(89)));
}
