/** Counterpart of shaders/perFragment/fullShadow.glsl. */
import type { Light } from 'three';
import { directedLights } from '../base/directedLights.js';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import type { Value } from '../base/values.js';

/** Whether no directed light arrives; null if some light casts no shadows and always does. */
export function isInFullShadow(lights: readonly Light[], receivedShadows: readonly ReceivedShadow[]): Value | null {
  const shadowed = receivedShadows.flatMap(({ isShadowed }) => isShadowed ?? []);
  if (shadowed.length === 0 || shadowed.length < directedLights(lights).length) return null;
  return shadowed.reduce((all, one) => all.and(one)).toVar();
}
