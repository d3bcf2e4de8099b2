import { LINE_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { TONE_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { leftOf, takenOf } from '../chunks/crossedTones.js';
import { handTone } from './hand.js';
import type { Family, HatchingParameters, Lean } from './read.js';
import type { FamilyPrinter } from './ruledLines.js';

const { float, If, max, mix, select } = tsl;

/** Counterpart of shaders/techniques/lines/hatchLayer.glsl: lines, with other families across them in the darks. */

const crossFrom = /* @__PURE__ */ hatchingUniform('crossFrom', 'float');
const layerTurns = /* @__PURE__ */ hatchingUniform('layerTurns', 'vec4');
const lineContrast = /* @__PURE__ */ hatchingUniform('lineContrast', 'float');

/** How lines are printed. */
export interface Printing {
  /** Whether they are strokes of a pen, or of a hand. */
  isPen: boolean;
  printFamily: FamilyPrinter;
}

/** The ink of a tone, or of both tones of strokes that end at shadows; one number stands for two equal ones. */
const inkOf = ({ castShadows }: HatchingParameters, tones: Value): Value =>
  castShadows ? tones.x.add(tones.y) : tones;

/** The angle of the families that cross in the darks. */
const leanOfDarks = (): Lean => [layerTurns.x.toVar(), layerTurns.y.toVar()];

/** The angle of families that lean back, across the first family and across those of its darks. */
const leanBack = (): Lean => [layerTurns.z.negate().toVar(), layerTurns.w.negate().toVar()];

/** The darkness of three families printed over one another. */
export function families(
  h: HatchingParameters,
  first: Value | null,
  crossing: Value,
  { printFamily, lean }: Pick<Printing, 'printFamily'> & { lean: Lean },
): Value {
  // One of the two families that lean back is left out where the first has no lines, since both would coincide.
  const shareB = select(lean[1].lessThan(0), h.shareB.add(h.firstShare).sub(1), h.shareB).toVar();
  const blankB = mix(1, crossing.oneMinus(), shareB).toVar();
  const blankC = crossing.oneMinus().div(max(blankB, 1e-4)).toVar();
  const blank = float(1).toVar();
  const print = (tone: Value, least: number, family: () => Family): void => {
    If(inkOf(h, tone).greaterThan(least), () => {
      blank.mulAssign(printFamily(h, family(), handTone(h.pressure, tone).toVar()).oneMinus());
    });
  };
  if (first) print(first, 0, () => h.firstFamily());
  // Families without ink are skipped.
  print(blankB.oneMinus().toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(true, lean));
  print(blankC.oneMinus().toVar(), LINE_CONSTANTS.LEAST_TONE, () => h.crossingFamily(false, lean));
  return blank.oneMinus();
}

/** Fades lines into an even grey of their tone where they would shimmer. */
function contrasted({ castShadows }: HatchingParameters, tones: Value, darkness: Value): Value {
  const tone = castShadows ? mix(tones.x, tones.y, castShadows.takenHere) : tones;
  return select(tone.greaterThanEqual(1), 1, mix(tone, darkness, lineContrast));
}

/** All families together leave as much blank as the tone does. */
export function hatchLayer(h: HatchingParameters, tone: Value, { isPen, printFamily }: Printing): Value {
  const kept = isPen ? TONE_CONSTANTS.KEPT_BY_PEN : TONE_CONSTANTS.KEPT_SHARE;
  const first = h.firstShare.mul(takenOf(tone, crossFrom, kept)).toVar();
  const others = leftOf(tone, first).toVar();
  let darkness: Value;
  if (isPen) {
    // Two families cross at a slant and would leave rows of rhombs open in the darks: the third leans back.
    const second = takenOf(others, float(TONE_CONSTANTS.THIRD_FROM), kept).toVar();
    const third = leftOf(others, second).toVar();
    const those = families(h, first, second, { printFamily, lean: leanOfDarks() }).oneMinus();
    darkness = those.mul(families(h, null, third, { printFamily, lean: leanBack() }).oneMinus()).oneMinus();
  } else darkness = families(h, first, others, { printFamily, lean: leanOfDarks() });
  return contrasted(h, tone, darkness);
}

/**
 * Counterpart of shaders/techniques/lines/shadowStrokes.glsl: families of lines in shadows, leaning back across the first family and
 * across those of its darks.
 */

export const shadowLayer = (h: HatchingParameters, tone: Value, { printFamily }: Printing): Value =>
  contrasted(h, tone, families(h, null, tone, { printFamily, lean: leanBack() }));
