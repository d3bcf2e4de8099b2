import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { tsl, type Value } from '../base/values.js';

const { max, min } = tsl;

/** Counterpart of shaders/chunks/crossedTones.glsl: shares a tone among layers that cross from some tone on. */

/**
 * The part of a tone that a layer prints itself, if other layers cross it above the tone `from`.
 *
 * @param kept the share of the tone above `from` that it still prints
 */
export const takenOf = (tone: Value, from: Value, kept: number = TONE_CONSTANTS.KEPT_SHARE): Value =>
  min(tone, from).add(max(tone.sub(from), 0).mul(kept));

/** The tone that a layer leaves to the others: exactly 0 up to where they begin. */
export const leftOf = (tone: Value, taken: Value): Value => max(tone.sub(taken), 0).div(max(taken.oneMinus(), 1e-4));

/** Counterpart of shaders/chunks/shadowStrokes.glsl: strokes in shadows. */

/**
 * The darkness where a layer of shadow strokes lies over the strokes of the light, which run on. That layer adds what the tone lacks: 1 −
 * (1 − T)/(1 − T_unshadowed).
 *
 * @param unshadowed the tone without shadows; null where they only darken
 */
export function hatchInShadow(
  tone: Value,
  unshadowed: Value | null,
  hatch: (tone: Value) => Value,
  shadowLayer: (tone: Value) => Value,
): Value {
  if (!unshadowed) return hatch(tone);
  const shadow = leftOf(tone, unshadowed).toVar();
  return hatch(unshadowed).oneMinus().mul(shadowLayer(shadow).oneMinus()).oneMinus();
}
