import { acceptSetting } from './acceptSetting.js';
import type { CameraView } from './CameraView.js';
import { PRESET_NAMES } from './presetLabels.js';
import { firstView, presetLook } from './presets.js';
import { defaultSettings, SETTING_KEYS, SETTINGS, type SettingKey, type Settings } from './settings.js';

const DECIMALS = 1000;

/** What older links call values, and what those are called now. */
const FORMER_VALUES: Partial<Record<SettingKey, Record<string, string>>> = {
  strokeLayers: { 1: 'single', 2: 'lights' },
};

/** Settings and camera as the hash of a URL. Defaults are left out, but for the technique: no hash at all stands for the first view. */
export function writeLink(settings: Settings, camera: CameraView | undefined): string {
  const parameters = new URLSearchParams();
  for (const key of SETTING_KEYS) {
    // A link cannot refer to a dropped file.
    if (settings[key] === 'file' || (settings[key] === SETTINGS[key].default && key !== 'technique')) continue;
    parameters.set(key, String(settings[key]));
  }
  if (camera) {
    const numbers = [...camera.position, ...camera.target].map((value) => Math.round(value * DECIMALS) / DECIMALS);
    parameters.set('camera', numbers.join(','));
  }
  return parameters.toString();
}

/** Reads what {@link writeLink} wrote. Unknown names and invalid values are ignored. Nothing at all is the first view; `preset` is what the others differ from. */
export function readLink(hash: string): { settings: Settings; camera: CameraView | undefined } {
  const parameters = new URLSearchParams(hash.replace(/^#/, ''));
  const preset = PRESET_NAMES.find((name) => name === parameters.get('preset'));
  const settings = parameters.size === 0 ? firstView() : { ...defaultSettings(), ...(preset && presetLook(preset)) };
  for (const key of SETTING_KEYS) {
    const text = parameters.get(key);
    const value = text === null ? undefined : acceptSetting(key, FORMER_VALUES[key]?.[text] ?? text);
    if (value !== undefined && value !== 'file') Object.assign(settings, { [key]: value });
  }
  const numbers = parameters.get('camera')?.split(',').map(Number) ?? [];
  const isCamera = numbers.length === 6 && numbers.every((value) => Number.isFinite(value) && Math.abs(value) <= 100);
  const [x, y, z, tx, ty, tz] = numbers as [number, number, number, number, number, number];
  return { settings, camera: isCamera ? { position: [x, y, z], target: [tx, ty, tz] } : undefined };
}
