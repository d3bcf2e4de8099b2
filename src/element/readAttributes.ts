import { type HatchingPreset, type PresetName, presets } from 'three-hatching';

/** A direction from the model, in degrees. */
export interface Direction {
  /** The angle from the front of the model to the right, as seen in the initial view. */
  azimuth: number;
  /** The angle above the horizon. */
  elevation: number;
}

/** What a drag or an arrow key turns. */
export type Controls = 'none' | 'orbit' | 'light';

const DEFAULT_PRESET: PresetName = 'pen';
const MAX_ELEVATION = 90;

/**
 * Reads the preset.
 *
 * @param text the attribute; null or '' for the default, `pen`
 * @throws Error that lists all presets, if there is none of this name
 */
export function readPreset(text: string | null): HatchingPreset {
  const name = text?.trim() || DEFAULT_PRESET;
  if (Object.hasOwn(presets, name)) return presets[name as PresetName];
  throw new Error(`There is no preset "${name}". There are ${Object.keys(presets).join(', ')}.`);
}

/**
 * Reads the address of a hand.
 *
 * @param text the attribute; null or '' for the preset's own strokes
 * @param preset that draws with it
 * @throws Error that lists the presets that draw with a pen, if this one does not
 */
export function readHand(text: string | null, preset: HatchingPreset): string | undefined {
  const address = text?.trim();
  if (!address) return undefined;
  const drawsWithPen = ({ material }: HatchingPreset): boolean => material?.technique === 'pen';
  if (drawsWithPen(preset)) return address;
  const pens = Object.entries(presets).flatMap(([name, one]) => (drawsWithPen(one) ? [name] : []));
  throw new Error(`A hand needs a preset that draws with a pen: ${pens.join(', ')}.`);
}

/** The attributes that override a number of the preset: the property of the material or of its composition, and its range in words. */
export const LOOK_NUMBERS = {
  'color-fill': {
    property: 'colorFill',
    isOfComposition: false,
    words: 'from 0, ink alone, to 1, the colours of the model',
  },
  'color-hatching': { property: 'colorHatching', isOfComposition: false, words: 'from 0 to 1' },
  exposure: { property: 'exposureCompensation', isOfComposition: true, words: 'above 0' },
  vignette: { property: 'vignette', isOfComposition: true, words: 'from 0 to 1' },
} as const;

export type LookNumber = keyof typeof LOOK_NUMBERS;

/**
 * Reads a number that overrides one of the preset.
 *
 * @param text the attribute; null or '' keeps the preset's number
 * @throws Error unless it is a number within the range
 */
export function readLookNumber(name: LookNumber, text: string | null): number | undefined {
  const word = text?.trim();
  if (!word) return undefined;
  const value = Number(word);
  // The exposure is a factor, the others are shares.
  const isRight = name === 'exposure' ? value > 0 && value < Infinity : value >= 0 && value <= 1;
  if (isRight) return value;
  throw new Error(`The ${name} is "${text}", but must be a number ${LOOK_NUMBERS[name].words}.`);
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
