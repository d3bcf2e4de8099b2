/** Counterpart of shaders/chunks/shadowStrokes.glsl: strokes in shadows. */
import { tsl, type Value } from '../base/values.js';
import { leftOf } from './crossedTones.js';

const { float } = tsl;

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
  return float(1).sub(
    float(1)
      .sub(hatch(unshadowed))
      .mul(float(1).sub(shadowLayer(shadow))),
  );
}
