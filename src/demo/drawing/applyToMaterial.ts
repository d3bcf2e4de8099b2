import { MathUtils, Vector2 } from 'three';
import type { HatchingMaterial } from 'three-hatching';
import type { Settings } from '../settings/settings.js';
import { TONE_CURVES } from '../settings/settingValues.js';

const rotations = { along: () => 0, towards: () => Math.PI / 2, angle: MathUtils.degToRad };
const offset = new Vector2();

/** Copies settings to a material. The technique is a parameter of its own, because a comparison draws with two. */
export function applyToMaterial(
  material: HatchingMaterial,
  settings: Settings,
  technique: Settings['technique'] = settings.technique,
): void {
  material.technique = technique === 'adjacencyCrisp' ? 'adjacency' : technique;
  material.crisp = technique === 'adjacencyCrisp';
  material.toneNormal = settings.toneNormal;
  material.strokeScale = settings.strokeScale;
  material.strokeRotation = rotations[settings.strokeDirection](settings.strokeAngle);
  material.strokeOffset.copy(offset.set(settings.offsetU, settings.offsetV));
  material.screenConstancy = settings.screenConstancy / 100;
  material.anchorSpacing = settings.anchorSpacing;
  material.lineField = settings.lineField;
  material.strokeLayers = settings.strokeLayers;
  material.crossFrom = settings.crossFrom / 100;
  material.crossAngle = MathUtils.degToRad(settings.crossAngle);
  material.handmade = settings.handmade / 100;
  material.edgePixels = settings.edge;
  material.toneModel = settings.toneModel;
  material.toneSteps = settings.toneSteps;
  material.shininess = settings.shininess;
  material.toneCurve = TONE_CURVES[settings.toneCurve];
  material.reflectedLight = settings.reflectedLight / 100;
  material.levelRule = settings.levelRule;
  material.creaseAngle = MathUtils.degToRad(settings.creaseAngle);
  material.ink.set(settings.ink);
  material.inkBlend = settings.inkBlend;
  material.paper.set(settings.paper);
  material.color.set(settings.color);
  material.debugView = settings.debugView;
}
