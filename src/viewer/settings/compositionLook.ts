import { MathUtils } from 'three';
import type { HatchingBackgroundParameters, HatchingMaterialParameters } from 'three-hatching';
import type { Settings } from './settings.js';

/** The composition parameters of the material that are not properties of the settings' own name. */
export const compositionLook = ({ depth, depthStrength, focus, focusX, focusY, focusZ }: Settings) =>
  ({
    depthFade: depth === 'auto' ? 'auto' : depth === 'on' ? depthStrength / 100 : 0,
    focus: focus === 'on' ? [focusX, focusY, focusZ] : null,
  }) satisfies HatchingMaterialParameters;

/** The parameters of the background, with spacing in CSS pixels; undefined if there is no background. */
export function backgroundLook(
  settings: Settings,
): Omit<Required<HatchingBackgroundParameters>, 'contrast'> | undefined {
  if (settings.background === 'none') return undefined;
  return {
    tone: settings.backgroundTone / 100,
    spacing: settings.backgroundSpacing,
    direction: MathUtils.degToRad(settings.backgroundDirection),
    extent: settings.backgroundExtent / 100,
    ink: settings.ink,
  };
}
