/** Counterpart of shaders/outlines/wobble.glsl: the unsteadiness of a hand, a slow screen-space offset that is fixed to the object. */
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { radius } from './points.js';

const { dot, sin, vec2, vec3 } = tsl;
const { ACROSS_BEND, ACROSS_BENT, FINE_PHASE, STRAY_ACROSS, STRAY_FINELY, STRAY_SHARES, STRAY_UP } = OUTLINE_CONSTANTS;
const { UP_BEND, UP_BENT, UP_PHASE } = OUTLINE_CONSTANTS;

/** Pixels. */
export const wobble: Value = /* @__PURE__ */ hatchingUniform('wobble', 'float');

const wave = (p: Value, direction: readonly [number, number, number]): Value => dot(p, vec3(...direction));

/** The pressure of the hand along the outline, from −1 to 1, in waves of about half the radius. */
export function pressureWave(anchor: Value): Value {
  const p = anchor.div(radius).toVar();
  return sin(dot(p, vec3(-5.3, 6.1, 7.9)).add(sin(dot(p, vec3(4.7, 3.9, -6.7))).mul(2.1)));
}

/** Sines in three directions, whose phases vary with one another, so that nothing seems to repeat. */
export function wobbleAt(anchor: Value): Value {
  const p = anchor.div(radius).toVar();
  const a = sin(wave(p, STRAY_ACROSS).add(sin(wave(p, ACROSS_BENT)).mul(ACROSS_BEND)));
  const b = sin(
    wave(p, STRAY_UP)
      .add(sin(wave(p, UP_BENT)).mul(UP_BEND))
      .add(UP_PHASE),
  );
  const c = sin(wave(p, STRAY_FINELY).add(FINE_PHASE)).mul(STRAY_SHARES[1]).toVar();
  return vec2(a.mul(STRAY_SHARES[0]).add(c), b.mul(STRAY_SHARES[0]).sub(c)).mul(wobble);
}
