/** Counterpart of shaders/outlines/hidden.glsl: outlines behind a surface, thin and dashed or faint, as in technical drawings. */
import { OUTLINE_CONSTANTS } from '../../../look/constants/outlineConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { If, abs, clamp, float, floor, select, smoothstep } = tsl;
const { DASH, FAINT, GAP, HIDDEN_WEIGHT, WHOLE_FROM } = OUTLINE_CONSTANTS;

const isDashed = /* @__PURE__ */ hatchingUniform('isDashed', 'float');

export const hiddenWeight = (weight: Value): Value => smoothstep(0, WHOLE_FROM, weight).mul(HIDDEN_WEIGHT);

/**
 * The share of a pixel that is drawn, by dashes and gaps. All in pixels.
 *
 * @param place along a piece that is `size` long
 * @param fromOrigin from the screen position of the object, so that dashes move with it
 */
export function hiddenCoverage(place: Value, size: Value, along: Value, fromOrigin: Value, width: Value): Value {
  const coverage = float(FAINT).toVar();
  If(isDashed.greaterThan(0.5), () => {
    const gap = width.mul(GAP).toVar();
    const period = width.mul(DASH + GAP).toVar();
    const x = float(0).toVar();
    If(size.greaterThan(period.mul(2)), () => {
      // An edge begins and ends with a dash.
      const whole = size.add(gap).toVar();
      period.assign(whole.div(floor(whole.div(period).add(0.5))));
      x.assign(clamp(place, 0, size));
    }).Else(() => {
      // The pieces of a curve are shorter than dashes, so their pattern follows the screen.
      x.assign(select(abs(along.x).greaterThan(abs(along.y)), fromOrigin.x, fromOrigin.y));
    });
    const half = period.sub(gap).mul(0.5).toVar();
    const within = x.sub(period.mul(floor(x.div(period))));
    coverage.assign(clamp(half.sub(abs(within.sub(half))).add(0.5), 0, 1));
  });
  return coverage;
}
