import { LINE_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import type { HatchingTechnique } from '../../../look/hatchingProperties.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { leftOf, takenOf } from '../chunks/crossedTones.js';
import { handTone } from './hand.js';
import type { Family, HatchingParameters } from './read.js';
import { ruledLines } from './ruledLines.js';

const { float, If, max, mix, select } = tsl;

/** Counterpart of shaders/techniques/lines/hatchLayer.glsl: lines, with other families across them in the darks. */

const crossFrom = /* @__PURE__ */ hatchingUniform('crossFrom', 'float');
const layerTurns = /* @__PURE__ */ hatchingUniform('layerTurns', 'vec4');
const lineContrast = /* @__PURE__ */ hatchingUniform('lineContrast', 'float');

/** The darkness of three families printed over one another. */
export function families(
  h: HatchingParameters,
  first: Value | null,
  crossing: Value,
  { technique, isOther }: { technique: HatchingTechnique; isOther: boolean },
): Value {
  const { x, y, z, w } = layerTurns;
  const lean = isOther ? ([z.negate(), w.negate()] as const) : ([x, y] as const);
  // One of the two families that lean back is left out where the first has no lines, since both would coincide.
  const shareB = isOther ? h.shareB.add(h.firstShare).sub(1) : h.shareB;
  const blankB = mix(1, crossing.oneMinus(), shareB).toVar();
  const blankC = crossing.oneMinus().div(max(blankB, 1e-4)).toVar();
  const blank = float(1).toVar();
  const print = (tone: Value, least: number, family: () => Family): void => {
    If(tone.greaterThan(least), () => {
      blank.mulAssign(ruledLines(h, family(), handTone(h.pressure, tone).toVar(), technique).oneMinus());
    });
  };
  if (first) print(first, 0, () => h.firstFamily());
  // Families without ink are skipped.
  print(blankB.oneMinus().toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(true, lean, isOther));
  print(blankC.oneMinus().toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(false, lean, isOther));
  return blank.oneMinus();
}

/** Fades lines into an even grey of their tone where they would shimmer. */
const contrasted = (tone: Value, darkness: Value): Value =>
  select(tone.greaterThanEqual(1), 1, mix(tone, darkness, lineContrast));

/** All families together leave as much blank as the tone does. */
export function hatchLayer(h: HatchingParameters, tone: Value, technique: HatchingTechnique): Value {
  const kept = technique === 'pen' ? TONE_CONSTANTS.KEPT_BY_PEN : TONE_CONSTANTS.KEPT_SHARE;
  const first = h.firstShare.mul(takenOf(tone, crossFrom, kept)).toVar();
  const others = leftOf(tone, first).toVar();
  let darkness: Value;
  if (technique === 'pen') {
    // Two families cross at a slant and would leave rows of rhombs open in the darks: the third leans back.
    const second = takenOf(others, float(TONE_CONSTANTS.THIRD_FROM), kept).toVar();
    const third = leftOf(others, second).toVar();
    const those = families(h, first, second, { technique, isOther: false }).oneMinus();
    darkness = those.mul(families(h, null, third, { technique, isOther: true }).oneMinus()).oneMinus();
  } else darkness = families(h, first, others, { technique, isOther: false });
  return contrasted(tone, darkness);
}

/**
 * Counterpart of shaders/techniques/lines/shadowStrokes.glsl: families of lines in shadows, leaning back across the first family and
 * across those of its darks.
 */

export const shadowLayer = (h: HatchingParameters, tone: Value, technique: HatchingTechnique): Value =>
  contrasted(tone, families(h, null, tone, { technique, isOther: true }));
