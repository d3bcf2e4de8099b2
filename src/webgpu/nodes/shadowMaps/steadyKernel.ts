/** Counterpart of shaders/shadowMaps/steadyKernel.glsl: a tent filter with samples no more than a texel apart. */
import { SHADOW_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { tsl, type Value } from '../base/values.js';

const { abs, ceil, clamp, float, int, Loop, max } = tsl;

const samplesAside = (radius: Value): Value => int(clamp(ceil(radius), 0, SHADOW_CONSTANTS.MOST_SAMPLES));

function tentWeight(x: Value, y: Value, span: Value): Value {
  const area = span.sub(abs(x)).mul(span.sub(abs(y)));
  return area.div(span.mul(span).mul(span).mul(span));
}

/**
 * The weighted mean of samples in a grid.
 *
 * @param radius of the grid, texels
 * @param passes the light that passes at an offset, texels
 */
export function steadily(radius: Value, passes: (x: Value, y: Value) => Value): Value {
  const n = samplesAside(radius).toVar();
  const span = float(n).add(1).toVar();
  const away = radius.div(max(span.sub(1), 1)).toVar();
  const sum = float(0).toVar();
  const range = (name: string): object => ({ start: n.negate(), end: n, type: 'int', condition: '<=', name });
  Loop(range('row'), ({ row }) => {
    Loop(range('column'), ({ column }) => {
      const [x, y] = [float(column).toVar(), float(row).toVar()];
      sum.addAssign(tentWeight(x, y, span).mul(passes(x.mul(away), y.mul(away))));
    });
  });
  return sum;
}
