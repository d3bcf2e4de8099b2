import { type HatchingPreset, type PresetName, presets } from 'three-hatching';

/** Where something lies on a sphere around the model, in degrees. */
export interface Direction {
  /** From the front of the model to the right, as the viewer sees it at first. */
  azimuth: number;
  /** Above the horizon. */
  elevation: number;
}

/** What a drag or an arrow key turns. */
export type Controls = 'none' | 'orbit' | 'light';

const DEFAULT_PRESET: PresetName = 'pen';
/** From the upper left, as in most drawings of the right-handed. */
const DEFAULT_LIGHT: Direction = { azimuth: -45, elevation: 40 };
const MOST_ELEVATION = 90;

/**
 * The preset of a name.
 *
 * @param text of the attribute; null or '' for the default, `pen`
 * @throws Error that names all presets, if there is no such
 */
export function readPreset(text: string | null): HatchingPreset {
  const name = text?.trim() || DEFAULT_PRESET;
  if (Object.hasOwn(presets, name)) return presets[name as PresetName];
  throw new Error(`There is no preset "${name}". There are ${Object.keys(presets).join(', ')}.`);
}

/**
 * The direction of the light.
 *
 * @param text of the attribute: azimuth and elevation in degrees, as `-45 40`; null or '' for the default
 * @throws Error if it is not two numbers, or the elevation is not between −90 and 90
 */
export function readLight(text: string | null): Direction {
  const words = (text ?? '').split(/[\s,]+/).filter(Boolean);
  if (words.length === 0) return { ...DEFAULT_LIGHT };
  const [azimuth, elevation] = words.map(Number);
  if (words.length === 2 && Number.isFinite(azimuth) && Math.abs(elevation) <= MOST_ELEVATION) {
    return { azimuth, elevation };
  }
  throw new Error(`The light is "${text}", but must be its azimuth and elevation in degrees, as "-45 40".`);
}

/**
 * What can be turned.
 *
 * @param text of the attribute: null for nothing, `light` for the light, anything else for the model
 */
export function readControls(text: string | null): Controls {
  if (text === null) return 'none';
  return text.trim().toLowerCase() === 'light' ? 'light' : 'orbit';
}
