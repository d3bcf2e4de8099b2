import { MathUtils, Vector2 } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import type { Settings } from './settings.js';

const rotations = { along: () => 0, towards: () => Math.PI / 2, angle: MathUtils.degToRad };
const offset = new Vector2();

/** Carries over the settings that both drawings of a comparison share. */
export function applyToMaterial(material: HatchingMaterial, settings: Settings): void {
  material.strokeScale = settings.strokeScale;
  material.strokeRotation = rotations[settings.strokeDirection](settings.strokeAngle);
  material.strokeOffset.copy(offset.set(settings.offsetU, settings.offsetV));
  material.toneModel = settings.toneModel;
  material.toneNormal = settings.toneNormal;
  material.toneSteps = settings.toneSteps;
  material.shininess = settings.shininess;
  material.creaseAngle = MathUtils.degToRad(settings.creaseAngle);
  material.ink.set(settings.ink);
  material.paper.set(settings.paper);
  material.color.set(settings.color);
  material.debugView = settings.debugView;
}
