/** The twin of shaders/techniques/engraved/hatchLayer.glsl: engraved lines, and other families that cross them in the darks. */
import { LINE_CONSTANTS } from '../../../../engraving/constants/lineConstants.js';
import { leftOf, takenOf } from '../../chunks/crossedTones.js';
import { hatchingUniform } from '../../uniforms.js';
import { tsl, type Value } from '../../values.js';
import type { HatchingParameters } from './Hatching.js';
import { handTone } from './hand.js';
import { type Family, ruledLines } from './ruledLines.js';

const { float, If, max, mix, select } = tsl;

/** The tone above which lines cross. */
const crossFrom = /* @__PURE__ */ hatchingUniform('crossFrom', 'float');
/** xy: cosine and sine of the angle between a family and what crosses it. */
const layerTurns = /* @__PURE__ */ hatchingUniform('layerTurns', 'vec4');
/** 0: an even grey of the same tone, while lines give way to others; 1: lines. */
const lineContrast = /* @__PURE__ */ hatchingUniform('lineContrast', 'float');

/** Cosine and sine of an angle. */
type Lean = readonly [cosine: Value, sine: Value];

/** The darkness of three families printed over one another. */
function families(h: HatchingParameters, first: Value, crossing: Value, lean: Lean): Value {
  const blankB = mix(1, float(1).sub(crossing), h.shareB).toVar();
  const blankC = float(1).sub(crossing).div(max(blankB, 1e-4)).toVar();
  const blank = float(1).toVar();
  const print = (tone: Value, least: number, family: () => Family): void => {
    If(tone.greaterThan(least), () => {
      blank.mulAssign(float(1).sub(ruledLines(family(), handTone(h.pressure, tone).toVar())));
    });
  };
  print(first, 0, h.firstFamily);
  // Families without ink cost nothing.
  print(float(1).sub(blankB).toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(true, lean));
  print(float(1).sub(blankC).toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(false, lean));
  return float(1).sub(blank);
}

/** Any number of families leaves as much blank as the tone does. */
export function hatchLayer(h: HatchingParameters, tone: Value): Value {
  const first = h.has.mul(takenOf(tone, crossFrom)).toVar();
  const darkness = families(h, first, leftOf(tone, first).toVar(), [layerTurns.x, layerTurns.y]);
  return select(tone.greaterThanEqual(1), 1, mix(tone, darkness, lineContrast));
}
