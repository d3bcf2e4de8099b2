import { MathUtils } from 'three';
import type { PresetName } from 'three-hatching';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import { firstView, presetLook, wholeLook } from '../../viewer/settings/presets.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { readLink } from '../../viewer/settings/shareLink.js';
import type { DrawingOptions } from '../DrawingOptions.js';

/** The settings and the camera of a drawing. */
export interface DrawnWith {
  settings: Settings;
  /** The camera of a link; undefined to frame the model. */
  camera: CameraView | undefined;
  /** Whether an option or a link sets the light; if not, it is chosen for the view. */
  isLit: boolean;
}

/**
 * The playground settings for a command line: those of the link or of the first view, overridden by options.
 *
 * @param link the hash of a link
 * @param upAxis up axis of the model
 */
export function settingsFor(
  { preset, view, light, shadows, up }: DrawingOptions,
  link: string | undefined,
  upAxis: Settings['upAxis'],
): DrawnWith {
  const linked = link === undefined ? undefined : readLink(link);
  const settings: Settings = linked?.settings ?? firstView();
  // A preset brings the playground's shadows along, unless a link sets its own.
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
