import type { HatchingMaterialParameters } from 'three-hatching';
import type { Settings } from './settings.js';

/** What the material takes of the settings of composition that are no properties of its own. */
export const compositionLook = ({ depth, depthStrength }: Settings): HatchingMaterialParameters => ({
  depthFade: depth === 'auto' ? 'auto' : depth === 'on' ? depthStrength / 100 : 0,
});
