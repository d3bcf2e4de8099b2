/** From radiance and colour of a surface to its tone. */
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { TONE_CURVES } from '../../../material/shaders/defineNames.js';
import { blankTable, TONE_CURVE_TEXELS } from '../../../material/toneCurveTable.js';
import type { ReceivedShadow } from '../base/lights.js';
import { lightLuminance } from '../base/maths.js';
import { hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { type TextureValue, tsl, type Value } from '../base/values.js';
import { mirroredRoom, mirroredShare } from './metal.js';
import { hollowness, openToSky } from './occlusion.js';
import { shadowTone } from './softShadows.js';
import type { CastShadows } from './strokeShadows.js';

const { clamp, dot, float, floor, max, min, mix, pow, select, step, vec2, vec3 } = tsl;
const { NO_LIGHT, OPAQUE_TEXEL } = TONE_CONSTANTS;

/** The lighting of a surface at a fragment. */
export interface HatchingSurface {
  radiance: Value;
  /** Radiance that shadows have taken; null where shadows are not computed apart. */
  shadowed: Value | null;
  /** The share of the shadows' tone that is left; null where they do not dissolve. */
  shadowLeft: Value | null;
  /** The darkness of the surface's own colour, as far as it becomes tone. */
  darkness: Value;
  /** The lights that cast shadows, where shadows are computed apart. */
  receivedShadows: readonly ReceivedShadow[];
  /** The shadows at whose edges strokes end; undefined where edges cut strokes. */
  castShadows: CastShadows | undefined;
}

/** Counterpart of shaders/chunks/tone.glsl: tone in [0, 1], where 0 is paper. */

const toneSteps = /* @__PURE__ */ hatchingUniform('toneSteps', 'float');
const toneEnds = /* @__PURE__ */ hatchingUniform('toneEnds', 'vec2');
const exposure = /* @__PURE__ */ hatchingUniform('exposure', 'vec2');
const highlightRamp = /* @__PURE__ */ hatchingUniform('highlightRamp', 'vec2');

const highlightKept = (tone: Value): Value => tone.mul(clamp(highlightRamp.x.mul(tone).add(highlightRamp.y), 0, 1));

function toneFromRadiance(radiance: Value, { curve, toneModel }: ToneRules): Value {
  const tone = clamp(radiance, 0, 1).oneMinus().toVar();
  if (toneModel === 'toon') {
    const last = max(toneSteps.sub(1), 1);
    tone.assign(floor(tone.mul(last).add(0.5)).div(last));
  }
  return highlightKept(clamp(curvedTone(tone, curve), 0, 1).toVar());
}

const exposed = (radiance: Value): Value => exposure.x.mul(radiance).add(exposure.y);

/** A dark colour brings the tone towards that of no light, as if printed over it with dark ink. */
const darkenedByColor = (tone: Value, darkness: Value): Value => mix(tone, toneEnds.y, darkness);

/** Hollows go beyond the tone of no light, which leaves some paper: to full ink, or with light ink to bare paper. */
const deepened = (tone: Value, hollowness: Value): Value => mix(tone, step(toneEnds.x, toneEnds.y), hollowness);

/** The choices for turning radiance into tone. */
export interface ToneRules {
  /** Index of the tone curve. */
  curve: number;
  /** The choice `toneModel`. */
  toneModel: string;
  /** Whether the surface is metal that mirrors the room. */
  isMirror: boolean;
}

/** The tone of a light, as far as metal mirrors the room instead. */
function mirroredTone(tone: Value, rules: ToneRules): Value {
  if (!rules.isMirror) return tone;
  return mix(tone, toneFromRadiance(openToSky().mul(mirroredRoom()), rules), mirroredShare());
}

/** The tone of a surface under lights of some radiance. */
export function litTone(radiance: Value, { darkness }: HatchingSurface, rules: ToneRules): Value {
  const tone = mirroredTone(toneFromRadiance(exposed(radiance), rules), rules);
  return deepened(darkenedByColor(tone, darkness), hollowness());
}

function toneOfShadows({ radiance, shadowed, shadowLeft }: HatchingSurface, rules: ToneRules): Value {
  // Without shadows nothing is printed.
  if (!shadowed) return float(0);
  // The share of the light that arrives. Without any light that a shadow could take, nothing is printed.
  const all = radiance.add(shadowed).add(NO_LIGHT);
  const arriving = radiance.add(NO_LIGHT).div(all).toVar();
  // Full light prints nothing either, whatever tone the curve gives it.
  const tone = max(toneFromRadiance(arriving, rules).sub(arriving.mul(toneEnds.x)), 0).mul(shadowTone);
  // Light ink draws the lights: it leaves shadows blank, soft edges too.
  return select(toneEnds.y.lessThanEqual(toneEnds.x), float(0), shadowLeft ? tone.mul(shadowLeft) : tone);
}

/** The tone of a lit surface, shadows included. */
export const shadedTone = (surface: HatchingSurface, rules: ToneRules): Value =>
  rules.toneModel === 'shadow' ? toneOfShadows(surface, rules) : litTone(surface.radiance, surface, rules);

/** The tone of the same surface without shadows. */
export function unshadowedTone(surface: HatchingSurface, rules: ToneRules): Value {
  const { radiance, shadowed } = surface;
  if (rules.toneModel === 'shadow') return float(0);
  return litTone(shadowed ? radiance.add(shadowed) : radiance, surface, rules);
}

/** Counterpart of shaders/chunks/lightness.glsl: lightness L* over 100, of a luminance in [0, 1] (CIE 1976). */
export const lightness = (y: Value): Value =>
  select(
    y.lessThan(216 / 24389),
    y.mul(9.032963),
    pow(y, 1 / 3)
      .mul(1.16)
      .sub(0.16),
  );

/** Counterpart of shaders/chunks/toneCurve.glsl: from the tone of the light to the printed tone. */

const toneCurveTable = /* @__PURE__ */ hatchingTexture('toneCurveTable', /* @__PURE__ */ blankTable());

const tabledTone = (tone: Value): Value =>
  toneCurveTable
    .sample(
      vec2(
        tone
          .mul(TONE_CURVE_TEXELS - 1)
          .add(0.5)
          .div(TONE_CURVE_TEXELS),
        0.5,
      ),
    )
    .level(0).x;

/** @param curve index among `TONE_CURVES` */
export function curvedTone(tone: Value, curve: number): Value {
  const kind = TONE_CURVES[curve];
  if (kind === 'perceptual') return lightness(tone.oneMinus()).oneMinus();
  return kind === 'points' ? tabledTone(tone) : tone;
}

/** Counterpart of shaders/chunks/localDarkness.glsl: the tone of the surface's own colour. */

const colorHatching = /* @__PURE__ */ hatchingUniform('colorHatching', 'float');
const colorExposure = /* @__PURE__ */ hatchingUniform('colorExposure', 'float');
const colorFilter = /* @__PURE__ */ hatchingUniform('colorFilter', 'vec4');
const valueKnots = /* @__PURE__ */ hatchingUniform('valueKnots', 'vec4');
const valueBends = /* @__PURE__ */ hatchingUniform('valueBends', 'vec4');

/** The darkness of a colour beside white, as far as it becomes tone. Emitted light lessens it. */
export function localDarkness(color: Value, emitted: Value): Value {
  const light = lightness(clamp(dot(colorFilter.xyz, color), 0, 1)).toVar();
  const planned = dot(valueBends, max(valueKnots.sub(light), 0));
  const unlit = clamp(lightLuminance(emitted), 0, 1).oneMinus();
  return colorHatching.mul(mix(min(colorExposure.mul(light), 1).oneMinus(), planned, colorFilter.w)).mul(unlit);
}

/** Counterpart of shaders/chunks/localColor.glsl: the tint of the surface's own colour, and the part of it that becomes tone. */

const mapBlur = /* @__PURE__ */ hatchingUniform('mapBlur', 'float');
const colorFill = /* @__PURE__ */ hatchingUniform('colorFill', 'float');

/**
 * The colour that becomes tone: a map without details that are finer than strokes can show; where it is cut out, as it is.
 *
 * @param plain the colour without the map
 * @param map a texture node of the map, at its place
 */
export function tonedColor(plain: Value, seen: Value, map: TextureValue): Value {
  const coarse = map.bias(mapBlur).toVar();
  const isCoarse = mapBlur.greaterThan(0).and(coarse.w.greaterThanEqual(OPAQUE_TEXEL));
  return select(isCoarse, plain.mul(coarse.xyz), seen);
}

export const filledColor = (color: Value): Value => mix(vec3(1), color, colorFill);
