import type { Color, Texture, Vector4 } from 'three';
import { PRESET_MATERIALS } from '../../look/presetMaterials.js';
import type { HatchingLook } from '../../look/queries.js';
import type { ToneCurve } from '../fitToneCurve.js';

/** The parameters that turn the light and the colours of a scene into tone. */
export interface ToneFit {
  /** The factor on the radiance of a white surface. */
  scale: number;
  /** The offset that is added after it. */
  offset: number;
  /** The lightness of colours that are left blank, from 0, black, to 1, white (CIE lightness). Lighter colours are left blank too. */
  white: number;
  /** The occlusion, from 0 to less than 1, that counts as open to the sky, in open rooms and among many deep hollows; 0 elsewhere. */
  openOcclusion: number;
  /** The plan of values, from the colours of surfaces to darkness. */
  plan: ValuePlan;
}

/**
 * The curve of a plan of values: the darkness that the colours of a scene are drawn with, straight between a few lightnesses. The darkness of a
 * lightness L is the sum of `bends[i]` times `knots[i]` − L, where that is above 0.
 */
export interface ValueCurve {
  /** The weights of red, green and blue in the lightness, as of a filter before the lens. They make 1. */
  filter: readonly [red: number, green: number, blue: number];
  /** The lightnesses at which the slope of the darkness changes. */
  knots: readonly [number, number, number, number];
  /** By how much it becomes steeper there, towards black. */
  bends: readonly [number, number, number, number];
}

/** A plan of values: a curve, and the surfaces to which it gives one darkness instead. */
export interface ValuePlan extends ValueCurve {
  /** The tones of surfaces that consist of many small parts; null if there are none. */
  tones: PlannedTones | null;
}

/** What tells a surface from others: copies of a material, for another renderer or another look, are the same surface. */
export interface SurfaceFacts {
  readonly name: string;
  readonly color: Color;
  readonly map: Texture | null;
  readonly vertexColors: boolean;
}

/** The tones that a plan has for whole surfaces. */
export interface PlannedTones {
  /** The darkness of the surface of a material; undefined where it follows from the colours. Allocates nothing in a frame like the last. */
  of(material: SurfaceFacts): number | undefined;
}

/** The weights of red, green and blue in the luminance, as in three.js. */
export const LUMINANCE = [0.2126729, 0.7151522, 0.072175] as const;

/** Writes the weights of red, green and blue, and the share of the plan in the darkness. Allocates nothing. */
export function writeFilter(filter: ValuePlan['filter'], planned: number, into: Vector4): void {
  const [r, g, b] = LUMINANCE;
  into.set(r + planned * (filter[0] - r), g + planned * (filter[1] - g), b + planned * (filter[2] - b), planned);
}

/** A cache of whether a tone curve is that of a preset. */
const ofPresets = new WeakMap<object, boolean>();

/** Whether a tone curve is the user's own: points that no preset has. */
function isByHand(curve: ToneCurve): boolean {
  if (typeof curve === 'string') return false;
  let isOfPreset = ofPresets.get(curve);
  if (isOfPreset === undefined) {
    const points = JSON.stringify(curve);
    isOfPreset = Object.values(PRESET_MATERIALS).some(({ toneCurve }) => JSON.stringify(toneCurve) === points);
    ofPresets.set(curve, isOfPreset);
  }
  return !isOfPreset;
}

/**
 * Whether the exposure of a material is fitted to its scene: if it is `'fit'` or `'auto'`, except that a user's own tone curve already maps light
 * to tone, and that shadows alone are a share of the light, whatever its strength.
 */
export const isFitted = ({ composition, toneCurve, isHatchingShadowMaterial }: HatchingLook): boolean =>
  typeof composition?.exposure === 'string' && isHatchingShadowMaterial !== true && !isByHand(toneCurve as ToneCurve);
