/** Counterpart of shaders/chunks/tone.glsl: tone in [0, 1], where 0 is paper. */
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import type { HatchingSurface } from '../base/HatchingSurface.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { hollowness } from './occlude.js';
import { shadowTone } from './softShadows.js';
import { curvedTone } from './toneCurve.js';

const { clamp, float, floor, max, mix, select, step } = tsl;
const { NO_LIGHT } = TONE_CONSTANTS;

const toneSteps = /* @__PURE__ */ hatchingUniform('toneSteps', 'float');
/** Tones at full light and at none. */
const toneEnds = /* @__PURE__ */ hatchingUniform('toneEnds', 'vec2');
/** Factor on radiance, and offset. */
const exposure = /* @__PURE__ */ hatchingUniform('exposure', 'vec2');
/** Slope of the ramp that tone is multiplied by, and its value at tone 0. */
const highlightRamp = /* @__PURE__ */ hatchingUniform('highlightRamp', 'vec2');

const highlightKept = (tone: Value): Value => tone.mul(clamp(highlightRamp.x.mul(tone).add(highlightRamp.y), 0, 1));

function toneFromRadiance(radiance: Value, { curve, toneModel }: ToneRules): Value {
  const tone = float(1)
    .sub(clamp(radiance, 0, 1))
    .toVar();
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
}

const litTone = (radiance: Value, { darkness }: HatchingSurface, rules: ToneRules): Value =>
  deepened(darkenedByColor(toneFromRadiance(exposed(radiance), rules), darkness), hollowness());

function toneOfShadows({ radiance, shadowed, shadowLeft }: HatchingSurface, rules: ToneRules): Value {
  // Without shadows nothing is printed.
  if (!shadowed) return float(0);
  // The share of the light that arrives. Without any light that a shadow could take, nothing is printed.
  const all = radiance.add(shadowed).add(NO_LIGHT);
  const arriving = radiance.add(NO_LIGHT).div(all).toVar();
  // Where all of it arrives nothing is printed either, whatever tone the curve gives to full light.
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
