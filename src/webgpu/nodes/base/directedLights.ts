import type { Light } from 'three';

/** Whether a light shines from a place. */
export const hasPlace = (light: Light): boolean => 'isPointLight' in light || 'isSpotLight' in light;

/** The lights that have a direction, which are all but skies. */
export const directedLights = (lights: readonly Light[]): Light[] =>
  lights.filter((light) => 'isDirectionalLight' in light || hasPlace(light));
