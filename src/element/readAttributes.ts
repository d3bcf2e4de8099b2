import { type HatchingPreset, type PresetName, presets } from 'three-hatching';

/** A direction from the model, in degrees. */
export interface Direction {
  /** The angle from the front of the model to the right, as seen in the initial view. */
  azimuth: number;
  /** The angle above the horizon. */
  elevation: number;
}

/** The object that a drag or an arrow key turns. */
export type Controls = 'none' | 'orbit' | 'light';

const DEFAULT_PRESET: PresetName = 'pen';
const MAX_ELEVATION = 90;

/**
 * Reads the preset.
 *
 * @param text the attribute; null or '' for the default, `pen`
 * @throws Error that names all presets, if there is none of this name
 */
export function readPreset(text: string | null): HatchingPreset {
  const name = text?.trim() || DEFAULT_PRESET;
  if (Object.hasOwn(presets, name)) return presets[name as PresetName];
  throw new Error(`There is no preset "${name}". There are ${Object.keys(presets).join(', ')}.`);
}

/**
 * Reads how much of the model's own colours is printed under the ink.
 *
 * @param text the attribute, a number; null or '' leaves it to the preset
 * @throws Error if it is no number between 0 and 1
 */
export function readColorFill(text: string | null): number | undefined {
  const word = text?.trim();
  if (!word) return undefined;
  const fill = Number(word);
  if (fill >= 0 && fill <= 1) return fill;
  throw new Error(
    `The color-fill is "${text}", but must be a number from 0, ink alone, to 1, the colours of the model.`,
  );
}

/**
 * Reads the direction of the light.
 *
 * @param text the attribute: azimuth and elevation in degrees, such as `-45 40`
 * @returns undefined for null or '': the model gets a light that suits its first view
 * @throws Error if it does not consist of two numbers, or the elevation is not between −90 and 90
 */
export function readLight(text: string | null): Direction | undefined {
  const words = (text ?? '').split(/[\s,]+/).filter(Boolean);
  if (words.length === 0) return undefined;
  const [azimuth, elevation] = words.map(Number);
  if (words.length === 2 && Number.isFinite(azimuth) && Math.abs(elevation) <= MAX_ELEVATION) {
    return { azimuth, elevation };
  }
  throw new Error(`The light is "${text}", but must be its azimuth and elevation in degrees, as "-45 40".`);
}

/**
 * Reads what visitors can turn.
 *
 * @param text the attribute: null for nothing, `light` for the light only, any other value for model and light
 */
export function readControls(text: string | null): Controls {
  if (text === null) return 'none';
  return text.trim().toLowerCase() === 'light' ? 'light' : 'orbit';
}
