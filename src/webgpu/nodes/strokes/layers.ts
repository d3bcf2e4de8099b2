/** Layers of strokes that cross. */
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type Input, tsl, type Value } from '../base/values.js';
import { leftOf, takenOf } from '../chunks/crossedTones.js';
import { tilesPerObjectUnit } from '../chunks/thresholdMap.js';
import type { HatchingParameters } from './read.js';

const { float, max, pow, vec3 } = tsl;

/** Counterpart of shaders/techniques/strokes/layers.glsl: the same place in other layers of strokes. */

export const latticeSpacing: Value = /* @__PURE__ */ hatchingUniform('latticeSpacing', 'float');

export const crossingOf = ({ crossing }: HatchingParameters): Value => crossing;

/** The same place in another layer, whose strokes are turned. @param turn cosine and sine of the angle */
function turnedLayer(h: HatchingParameters, layer: number, [x, y]: readonly [Input, Input]): HatchingParameters {
  const { uAxis, vAxis, lean } = h;
  const shift = vec3(...TONE_CONSTANTS.LAYER_SHIFT).mul(latticeSpacing.div(tilesPerObjectUnit).mul(layer));
  return {
    ...h,
    point: h.point.add(shift).toVar(),
    uAxis: uAxis.mul(x).sub(vAxis.mul(y)).toVar(),
    vAxis: uAxis.mul(y).add(vAxis.mul(x)).toVar(),
    lean: vec3(lean.x.mul(x).sub(lean.y.mul(y)), lean.x.mul(y).add(lean.y.mul(x)), lean.z).toVar(),
  };
}

/** Counterpart of shaders/chunks/hatch.glsl: the darkness of the hatch, of its layers printed over one another. */

const crossFrom = /* @__PURE__ */ hatchingUniform('crossFrom', 'float');
const layerTurns = /* @__PURE__ */ hatchingUniform('layerTurns', 'vec4');

const oneMinus = (x: Value): Value => x.oneMinus().toVar();

/** The darkness of one layer: of strokes or of dots. */
export type HatchLayer = (h: HatchingParameters, tone: Value) => Value;

/** @param layers the choice `strokeLayers`; not `lights` with one light alone */
export function hatch(h: HatchingParameters, tone: Value, layers: string, hatchLayer: HatchLayer): Value {
  if (layers === 'lights') {
    // The second layer, along the other axis of the tensor, takes over as much of the tone as the lights disagree. At full tone any share
    // would fill both layers.
    const blank = max(oneMinus(tone), 1e-3).toVar();
    const share = crossingOf(h).mul(0.5).toVar();
    const first = hatchLayer(h, oneMinus(pow(blank, oneMinus(share))));
    const second = hatchLayer(turnedLayer(h, 1, [0, 1]), oneMinus(pow(blank, share)));
    return oneMinus(oneMinus(first).mul(oneMinus(second)));
  }
  if (layers !== 'tone') return hatchLayer(h, tone);
  const first = takenOf(tone, crossFrom).toVar();
  const others = leftOf(tone, first).toVar();
  const second = takenOf(others, float(TONE_CONSTANTS.THIRD_FROM)).toVar();
  const third = leftOf(others, second).toVar();
  const { x, y, z, w } = layerTurns;
  return oneMinus(
    oneMinus(hatchLayer(h, first))
      .mul(oneMinus(hatchLayer(turnedLayer(h, 1, [x, y]), second)))
      .mul(oneMinus(hatchLayer(turnedLayer(h, 2, [z, w]), third))),
  );
}

/** Counterpart of shaders/techniques/strokes/shadowStrokes.glsl: a layer for shadows, across the strokes of the light. */

export const shadowLayer = (h: HatchingParameters, tone: Value, hatchLayer: HatchLayer): Value =>
  hatchLayer(turnedLayer(h, 3, [0, 1]), tone);
