import type { Light } from 'three';

/** Whether a light has a position. */
export const hasPlace = (light: Light): boolean => 'isPointLight' in light || 'isSpotLight' in light;

/** The lights that have a direction: all but hemisphere lights. */
export const directedLights = (lights: readonly Light[]): Light[] =>
  lights.filter((light) => 'isDirectionalLight' in light || hasPlace(light));
