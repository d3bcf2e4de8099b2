/** Counterpart of shaders/chunks/toneCurve.glsl: from the tone of the light to the printed tone. */
import { TONE_CURVE_SPANS, TONE_CURVES } from '../../../material/shaders/shaderConventions.js';
import { hatchingElement, hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { lightness } from './lightness.js';

const { clamp, float } = tsl;

/** A monotone cubic spline: a start value, and the rise over each span. Unused spans add nothing. */
function splineAt(tone: Value): Value {
  const curved = hatchingUniform('toneCurveStart', 'float').toVar();
  for (let i = 0; i < TONE_CURVE_SPANS; i++) {
    const span = [0, 1].map((k) => hatchingElement('toneCurveSpans', 2 * i + k));
    const [a, b, c] = [0, 1, 2].map((k) => hatchingElement('toneCurveCubics', 3 * i + k));
    const t = clamp(tone.sub(span[0]).mul(span[1]), 0, 1).toVar();
    curved.addAssign(t.mul(a.add(t.mul(b.add(t.mul(c))))));
  }
  return curved;
}

/** @param curve index among `TONE_CURVES` */
export function curvedTone(tone: Value, curve: number): Value {
  const kind = TONE_CURVES[curve];
  if (kind === 'perceptual') return float(1).sub(lightness(float(1).sub(tone)));
  return kind === 'points' ? splineAt(tone) : tone;
}
