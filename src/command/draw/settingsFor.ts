import { MathUtils } from 'three';
import type { PresetName } from 'three-hatching';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import { firstView, presetLook, wholeLook } from '../../viewer/settings/presets.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { readLink } from '../../viewer/settings/shareLink.js';
import type { DrawingOptions } from '../DrawingOptions.js';

/** What a model is drawn with. */
export interface DrawnWith {
  settings: Settings;
  /** The camera of a link; undefined if the model is to be framed. */
  camera: CameraView | undefined;
  /** Whether somebody has placed the light, so that it is not to be found for the view. */
  isLit: boolean;
}

/**
 * The settings of the playground that a command line stands for: those of a link or of its first view, and then what options say.
 *
 * @param link the hash of a link
 * @param upAxis that of the model
 */
export function settingsFor(
  { preset, view, light, shadows, up }: DrawingOptions,
  link: string | undefined,
  upAxis: Settings['upAxis'],
): DrawnWith {
  const linked = link === undefined ? undefined : readLink(link);
  const settings: Settings = linked?.settings ?? firstView();
  // A preset has the shadows of the playground beside its hand, unless a link says otherwise.
  if (preset) Object.assign(settings, linked ? presetLook(preset as PresetName) : wholeLook(preset as PresetName));
  if (light) {
    const azimuth = MathUtils.euclideanModulo(light.azimuth + 180, 360) - 180;
    Object.assign(settings, { lightAzimuth: azimuth, lightElevation: light.elevation, lightFollows: 'model' });
  }
  if (shadows !== undefined) settings.shadows = shadows ? 'on' : 'off';
  if (settings.shadows === 'off' && settings.ground === 'shadow') settings.ground = SETTINGS.ground.default;
  const isUpLinked = link !== undefined && new URLSearchParams(link).has('upAxis');
  Object.assign(settings, {
    model: 'file',
    compare: SETTINGS.compare.default,
    debugView: SETTINGS.debugView.default,
    upAxis: up ?? (isUpLinked ? settings.upAxis : upAxis),
  });
  return { settings, camera: view ? undefined : linked?.camera, isLit: light !== undefined || linked !== undefined };
}
