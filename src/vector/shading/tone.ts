/** From light to the printed tone, as in tone.glsl, toneCurve.glsl, occlude.glsl and localDarkness.glsl. */
import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { clamp01, lightness, mix, smoothstep, type Vec3 } from '../../look/vectors.js';

const { CAVITY, HOLLOW } = TONE_CONSTANTS;

/** A curve of points as a sum of cubics, one per span; made by `fitToneCurve`. */
export interface CurveCubics {
  start: number;
  /** Per span its start, and 1 / its width. */
  spans: ArrayLike<number>;
  /** Per span the coefficients of t, t² and t³. */
  cubics: ArrayLike<number>;
}

/** From the tone of the light to the printed tone; null is the straight line. */
export function curvedTone(tone: number, curve: 'perceptual' | CurveCubics | null): number {
  if (curve === null) return tone;
  if (curve === 'perceptual') return 1 - lightness(1 - tone);
  const { start, spans, cubics } = curve;
  let curved = start;
  for (let i = 0; 2 * i < spans.length; i++) {
    const t = clamp01((tone - spans[2 * i]) * spans[2 * i + 1]);
    curved += t * (cubics[3 * i] + t * (cubics[3 * i + 1] + t * cubics[3 * i + 2]));
  }
  return curved;
}

/** The look of a surface, as far as tone depends on it. */
export interface ToneLook {
  curve: 'perceptual' | CurveCubics | null;
  /** Number of bands, or 0 for none. */
  steps: number;
  /** Factor on radiance, and offset. */
  exposure: readonly [number, number];
  /** Slope of the ramp that tone is multiplied by, and its value at tone 0. */
  highlightRamp: readonly [number, number];
  /** Tones at full light and at none. */
  toneEnds: readonly [number, number];
  /** Strength of ambient occlusion, and tone of deep hollows. */
  occlusion: number;
  hollowStrength: number;
  /** The occlusion that counts as open to the sky. */
  openOcclusion: number;
  /** Darkness of the surface's own colour, as far as it becomes tone. */
  darkness: number;
}

const highlightKept = (tone: number, [slope, height]: readonly [number, number]): number =>
  tone * clamp01(slope * tone + height);

/** The tone of a white surface's radiance, before colour and hollows. */
export function toneFromRadiance(radiance: number, { curve, steps, highlightRamp }: ToneLook): number {
  let tone = 1 - clamp01(radiance);
  if (steps > 0) {
    const last = Math.max(steps - 1, 1);
    tone = Math.floor(tone * last + 0.5) / last;
  }
  return highlightKept(clamp01(curvedTone(tone, curve)), highlightRamp);
}

/** The share of ambient light at a place, by its occlusion. */
export const openToSky = (occluded: number, occlusion: number): number => 1 - occlusion * occluded;

/** The share of directed light. */
export const openToLights = (occluded: number, occlusion: number): number =>
  1 - occlusion * occluded * smoothstep(0, CAVITY, occluded);

/**
 * The printed tone of a radiance at a place, by its occlusion, in [0, 1].
 *
 * @param mirror the light of the room that metal mirrors there, and the share of the tone that it decides
 */
export function shadedTone(
  radiance: number,
  occluded: number,
  look: ToneLook,
  mirror?: { readonly room: number; readonly share: number },
): number {
  const { exposure, toneEnds, darkness, hollowStrength, occlusion } = look;
  const shaded = toneFromRadiance(exposure[0] * radiance + exposure[1], look);
  const open = openToSky(occluded, occlusion);
  const inRoom = mirror ? mix(shaded, toneFromRadiance(open * mirror.room, look), mirror.share) : shaded;
  const tone = mix(inRoom, toneEnds[1], darkness);
  const hollowness = hollowStrength * occlusion * smoothstep(HOLLOW[0], HOLLOW[1], occluded);
  // Hollows go to full ink, or with light ink to bare paper.
  return mix(tone, toneEnds[1] >= toneEnds[0] ? 1 : 0, hollowness);
}

/** The numbers that colours become darkness by, as in localDarkness.glsl. */
export interface ColorTones {
  /** The share of the darkness that becomes tone. */
  colorHatching: number;
  /** The factor on the lightness. */
  colorExposure: number;
  /** The weights of red, green and blue in the lightness, and the share of the plan of values in the darkness. */
  colorFilter: readonly number[];
  /** The plan of values: the lightnesses at which the slope of the darkness changes, and by how much. */
  valueKnots: readonly number[];
  valueBends: readonly number[];
}

/**
 * The darkness of a colour beside white, as far as it becomes tone.
 *
 * @param color linear
 * @param emitted the luminance of the emitted light, linear
 */
export function localDarkness(color: Vec3, emitted: number, tones: ColorTones): number {
  const { colorHatching, colorExposure, colorFilter, valueKnots, valueBends } = tones;
  if (colorHatching === 0) return 0;
  const [r, g, b, share] = colorFilter;
  const light = lightness(clamp01(r * color[0] + g * color[1] + b * color[2]));
  const planned = valueKnots.reduce((sum, knot, i) => sum + valueBends[i] * Math.max(knot - light, 0), 0);
  return colorHatching * mix(1 - Math.min(colorExposure * light, 1), planned, share) * (1 - clamp01(emitted));
}
