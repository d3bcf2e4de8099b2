/** The twin of shaders/perFragment/fullShadow.glsl. */
import type { Light } from 'three';
import { directedLights } from '../base/directedLights.js';
import type { ToldLight } from '../base/ToldLight.js';
import type { Value } from '../base/values.js';

/** Whether no light arrives that has a direction; null where some always do. */
export function isInFullShadow(lights: readonly Light[], told: readonly ToldLight[]): Value | null {
  const shadowed = told.flatMap(({ isShadowed }) => isShadowed ?? []);
  if (shadowed.length === 0 || shadowed.length < directedLights(lights).length) return null;
  return shadowed.reduce((all, one) => all.and(one)).toVar();
}
