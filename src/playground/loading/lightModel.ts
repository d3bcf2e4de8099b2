import { MathUtils, Spherical } from 'three';
import { flatteringLight } from 'three-hatching';
import { lightsOfFile } from '../../viewer/sceneSetup/lightsOfFile.js';
import { acceptSetting } from '../../viewer/settings/acceptSetting.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import { lightOf, type SavedView } from '../../viewer/settings/savedViews.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { extrasInWorld } from '../maps/extrasInWorld.js';
import type { Viewport } from '../viewport/Viewport.js';

/**
 * Lights the shown model for its view, or by its file's lights, and applies the settings. A module of its own, loaded with the first file.
 *
 * @returns the light that suits the view, if the model is lit by its file instead
 */
export function lightModel(viewport: Viewport, settings: Settings): SavedView['light'] | undefined {
  // Turns the model upright before it is lit.
  viewport.apply(lookOf(settings));
  if (!viewport.model) return undefined;
  const { view } = viewport;
  const camera = view.isFramed ? view.roomiest : viewport.camera;
  const { direction } = flatteringLight(viewport.model.root, camera, { onGround: view.modelOutline });
  if (settings.lightFollows === 'viewer') direction.applyQuaternion(viewport.camera.quaternion.clone().invert());
  const { theta, phi } = new Spherical().setFromVector3(direction);
  const place = { lightAzimuth: MathUtils.radToDeg(theta), lightElevation: 90 - MathUtils.radToDeg(phi) };
  for (const key of ['lightAzimuth', 'lightElevation'] as const) {
    settings[key] = acceptSetting(key, place[key]) as number;
  }
  const found = lightOf(settings);
  const ofFile = lightsOfFile(extrasInWorld(viewport.model).lights);
  if (ofFile) Object.assign(settings, ofFile.settings);
  viewport.apply(lookOf(settings));
  // The shadow has changed.
  if (view.isFramed) view.frame();
  return ofFile && found;
}
