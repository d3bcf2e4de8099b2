import { MathUtils, Spherical } from 'three';
import { flatteringLight } from 'three-hatching';
import { lightsOfFile } from '../../viewer/sceneSetup/lightsOfFile.js';
import { acceptSetting } from '../../viewer/settings/acceptSetting.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import { lightOf, type SavedView } from '../../viewer/settings/savedViews.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { extrasInWorld } from '../maps/extrasInWorld.js';
import type { Stage } from '../viewport/Stage.js';

/**
 * Lights the shown model for its view or, if its file has lights, as these do, and applies the settings with that. A module of its own, which
 * is fetched with the first file.
 *
 * @returns the view with the light that suits it, if the model is lit by its file
 */
export function lightModel(stage: Stage, settings: Settings): SavedView['light'] | undefined {
  // The model is seen upright from here on.
  stage.apply(lookOf(settings));
  if (!stage.model) return undefined;
  const { view } = stage;
  const camera = view.isFramed ? view.roomiest : stage.camera;
  const { direction } = flatteringLight(stage.model.root, camera, { onGround: view.modelOutline });
  if (settings.lightFollows === 'viewer') direction.applyQuaternion(stage.camera.quaternion.clone().invert());
  const { theta, phi } = new Spherical().setFromVector3(direction);
  const place = { lightAzimuth: MathUtils.radToDeg(theta), lightElevation: 90 - MathUtils.radToDeg(phi) };
  for (const key of ['lightAzimuth', 'lightElevation'] as const) {
    settings[key] = acceptSetting(key, place[key]) as number;
  }
  const found = lightOf(settings);
  const ofFile = lightsOfFile(extrasInWorld(stage.model).lights);
  if (ofFile) Object.assign(settings, ofFile.settings);
  stage.apply(lookOf(settings));
  // The shadow is another one now.
  if (view.isFramed) view.frame();
  return ofFile && found;
}
