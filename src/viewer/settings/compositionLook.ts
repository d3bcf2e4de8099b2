import { MathUtils } from 'three';
import type { HatchingBackgroundParameters, HatchingMaterialParameters } from 'three-hatching';
import type { Settings } from './settings.js';

/** What the material takes of the settings of composition that are no properties of its own. */
export const compositionLook = ({ depth, depthStrength, focus, focusX, focusY, focusZ }: Settings) =>
  ({
    depthFade: depth === 'auto' ? 'auto' : depth === 'on' ? depthStrength / 100 : 0,
    focus: focus === 'on' ? [focusX, focusY, focusZ] : null,
  }) satisfies HatchingMaterialParameters;

/** The properties of the background, its spacing in pixels of the page; undefined if there is none. */
export function backgroundLook(settings: Settings): Required<HatchingBackgroundParameters> | undefined {
  if (settings.background === 'none') return undefined;
  return {
    tone: settings.backgroundTone / 100,
    contrast: 0.75,
    spacing: settings.backgroundSpacing,
    direction: MathUtils.degToRad(settings.backgroundDirection),
    extent: settings.backgroundExtent / 100,
    ink: settings.ink,
  };
}
