/** The twin of shaders/chunks/shadowStrokes.glsl: what shadows do to the drawing, beside darkening it. */
import { tsl, type Value } from '../base/values.js';
import { leftOf } from './crossedTones.js';

const { float } = tsl;

/**
 * The strokes of the light run on through the shadow. It lies over them as a layer of its own, which adds what the tone lacks:
 * 1 − (1 − T)/(1 − T_unshadowed).
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
