/** The twin of shaders/chunks/tone.glsl: tone in [0, 1], where 0 is paper. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { curvedTone } from './toneCurve.js';

const { clamp, float, floor, max, mix, step } = tsl;

const toneSteps = /* @__PURE__ */ hatchingUniform('toneSteps', 'float');
/** The tones that are printed where all light arrives, and where none does. */
const toneEnds = /* @__PURE__ */ hatchingUniform('toneEnds', 'vec2');
/** What radiance is multiplied by, and what is added. */
const exposure = /* @__PURE__ */ hatchingUniform('exposure', 'vec2');
/** The ramp that tone is multiplied by: its slope, and its height at tone 0. */
const highlightRamp = /* @__PURE__ */ hatchingUniform('highlightRamp', 'vec2');

const highlightKept = (tone: Value): Value => tone.mul(clamp(highlightRamp.x.mul(tone).add(highlightRamp.y), 0, 1));

function toneFromRadiance(radiance: Value, curve: number, isToon: boolean): Value {
  const tone = float(1)
    .sub(clamp(radiance, 0, 1))
    .toVar();
  if (isToon) {
    const last = max(toneSteps.sub(1), 1);
    tone.assign(floor(tone.mul(last).add(0.5)).div(last));
  }
  return highlightKept(clamp(curvedTone(tone, curve), 0, 1).toVar());
}

const exposed = (radiance: Value): Value => exposure.x.mul(radiance).add(exposure.y);

/** A dark colour brings the tone nearer to that of no light at all: with dark ink, it is printed over it. */
const darkenedByColor = (tone: Value, darkness: Value): Value => mix(tone, toneEnds.y, darkness);

/** Hollows go beyond the tone of no light, where some paper shows: to the darkest image, or for chalk to bare paper. */
const deepened = (tone: Value, hollowness: Value): Value => mix(tone, step(toneEnds.x, toneEnds.y), hollowness);

/**
 * The tone that light prints.
 *
 * @param darkness of the surface's own colour
 * @param hollowness see occlude.ts
 * @param curve the number of its kind
 */
export const shadedTone = (
  radiance: Value,
  darkness: Value,
  hollowness: Value,
  { curve, isToon }: { curve: number; isToon: boolean },
): Value => deepened(darkenedByColor(toneFromRadiance(exposed(radiance), curve, isToon), darkness), hollowness);
