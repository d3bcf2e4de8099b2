/** The twin of shaders/techniques/engraved/hatchLayer.glsl and of readCut.glsl: lines that a field cuts out of the object. */
import type { NodeBuilder } from 'three/webgpu';
import { FIELD_CONSTANTS } from '../../../../engraving/constants/fieldConstants.js';
import { HAND_CONSTANTS } from '../../../../engraving/constants/handConstants.js';
import { LINE_CONSTANTS } from '../../../../engraving/constants/lineConstants.js';
import { leftOf, takenOf } from '../../chunks/crossedTones.js';
import { type ScreenMap, screenGradient, screenMap } from '../../perFragment/screenGradient.js';
import { readViewToAnchor } from '../../perFragment/viewToAnchor.js';
import { hatchingUniform } from '../../uniforms.js';
import { tsl, type Value } from '../../values.js';
import { objectToField } from './emit.js';
import { across, fieldAt } from './fieldAxis.js';
import { handPoint, handPressure, handTone, slowWaves } from './hand.js';
import { type Family, ruledLines } from './ruledLines.js';
import { vField, vFieldNormal, vFieldPoint } from './varyings.js';

const { cross, dot, float, If, length, max, min, mix, normalize, select, smoothstep, sqrt } = tsl;
const { BARE_SLOPE, SIDE_FADE, SPARSEST_SLOPE } = FIELD_CONSTANTS;

/** The tone above which lines cross. */
const crossFrom = /* @__PURE__ */ hatchingUniform('crossFrom', 'float');
/** xy: cosine and sine of the angle between a family and what crosses it. */
const layerTurns = /* @__PURE__ */ hatchingUniform('layerTurns', 'vec4');
/** 0: an even grey of the same tone, while lines give way to others; 1: lines. */
const lineContrast = /* @__PURE__ */ hatchingUniform('lineContrast', 'float');

interface HatchingParameters {
  /** As the hand strays, from the origin of the field, tiles. */
  point: Value;
  pressure: Value;
  onScreen: ScreenMap;
  value: Value;
  valueOnScreen: Value;
  slope: Value;
  /** How far the first family has lines. */
  has: Value;
  sideB: Value;
  sideC: Value;
  shareB: Value;
}

export function readHatchingParameters(builder: NodeBuilder): HatchingParameters {
  const field = vField.toVar();
  const place = vFieldPoint.toVar();
  const normal = normalize(vFieldNormal).toVar();
  const waves = slowWaves(place.mul(HAND_CONSTANTS.HAND_WAVES)).toVar();
  const point = handPoint(place, waves).toVar();
  const onScreen = screenMap(normal, objectToField.mul(readViewToAnchor(builder)).toVar());
  const { value, gradient } = fieldAt(field, point);
  const along = dot(normal, gradient).toVar();
  const slope = sqrt(max(float(1).sub(along.mul(along)), 1e-12)).toVar();
  const has = smoothstep(BARE_SLOPE[0], BARE_SLOPE[1], slope).toVar();
  const sideB = across(field.xyz).toVar();
  const sideC = cross(field.xyz, sideB).toVar();
  const b = dot(normal, sideC).toVar();
  const c = dot(normal, sideB).toVar();
  const between = b
    .mul(b)
    .sub(c.mul(c))
    .div(max(slope.mul(slope), 1e-4));
  const shareB = mix(1, smoothstep(-SIDE_FADE, SIDE_FADE, between), has).toVar();
  const valueOnScreen = screenGradient(gradient, onScreen).toVar();
  return {
    ...{ point, pressure: handPressure(waves).toVar(), onScreen, value, valueOnScreen },
    ...{ slope, has, sideB, sideC, shareB },
  };
}

const firstFamily = ({ value, valueOnScreen, slope }: HatchingParameters): Family => ({
  value,
  perPixel: length(valueOnScreen),
  rise: min(slope.div(SPARSEST_SLOPE), 1),
});

function crossingFamily({ point, value, valueOnScreen, onScreen }: HatchingParameters, side: Value): Family {
  const { x, y } = layerTurns;
  return {
    value: x.mul(value).add(y.mul(dot(point, side))),
    perPixel: length(valueOnScreen.mul(x).add(screenGradient(side, onScreen).mul(y))),
    rise: float(1),
  };
}

/** The darkness of three families printed over one another. */
function families(h: HatchingParameters, first: Value, crossing: Value): Value {
  const blankB = mix(1, float(1).sub(crossing), h.shareB).toVar();
  const blankC = float(1).sub(crossing).div(max(blankB, 1e-4)).toVar();
  const blank = float(1).toVar();
  const print = (tone: Value, least: number, family: () => Family): void => {
    If(tone.greaterThan(least), () => {
      blank.mulAssign(float(1).sub(ruledLines(family(), handTone(h.pressure, tone).toVar())));
    });
  };
  print(first, 0, () => firstFamily(h));
  // Families without ink cost nothing.
  print(float(1).sub(blankB).toVar(), LINE_CONSTANTS.LEAST_TONE, () => crossingFamily(h, h.sideB));
  print(float(1).sub(blankC).toVar(), LINE_CONSTANTS.LEAST_TONE, () => crossingFamily(h, h.sideC));
  return float(1).sub(blank);
}

/** Any number of families leaves as much blank as the tone does. */
export function hatchLayer(h: HatchingParameters, tone: Value): Value {
  const first = h.has.mul(takenOf(tone, crossFrom)).toVar();
  const darkness = families(h, first, leftOf(tone, first).toVar());
  return select(tone.greaterThanEqual(1), 1, mix(tone, darkness, lineContrast));
}
