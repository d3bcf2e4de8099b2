/** Counterpart of shaders/techniques/lines/ruledLines.glsl: one family of lines. */
import { GROUND_CONSTANTS } from '../../../look/constants/lineConstants.js';
import type { HatchingTechnique } from '../../../look/hatchingProperties.js';
import { lineCoverage } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { cutFor, cutWidth, rowOctaves } from './carving.js';
import { handWidth, hash01 } from './hand.js';
import { penCoverage, penFor, thereOn } from './penStrokes.js';
import type { Family, HatchingParameters } from './read.js';
import { FRINGE, octaveOf, powerOf2, trianglePerPixelOf } from './strokeLengths.js';

const { abs, ceil, float, floor, fract, int, Loop, max, min, select } = tsl;

const toneEnds = /* @__PURE__ */ hatchingUniform('toneEnds', 'vec2');
const shadowTone = /* @__PURE__ */ hatchingUniform('shadowTone', 'float');

/**
 * A factor on the width of a line where a shadow dissolves: lines end one by one, instead of all thinning out together. The mean over all
 * lines is 1, so the tone stays.
 */
function lineLeft(line: Value, shadowLeft: Value): Value {
  const { ENDING, LEAST_LEFT, MOST_ENDING } = GROUND_CONSTANTS;
  const gone = min(shadowLeft.oneMinus().mul(ENDING).div(max(shadowLeft, LEAST_LEFT)), MOST_ENDING).toVar();
  const kept = select(gone.lessThan(1), gone.mul(0.5).oneMinus(), float(0.5).div(gone));
  // Half a turn from the hash of widths, so that the lines that stay are neither the widest nor the thinnest.
  return max(gone.mul(fract(hash01(line).add(0.5))).oneMinus(), 0).div(kept);
}

/** The tone that the spacing of cut rows depends on: constant across the edges of a shadow, where cuts widen. */
const rowTone = ({ shadowLeft }: HatchingParameters, tone: Value): Value =>
  shadowLeft ? max(tone, toneEnds.y.mul(shadowTone).mul(shadowLeft)).toVar() : tone;

/** The lines of a family that may touch a pixel. */
interface NearLines {
  octave: Value;
  oldRoom: Value;
  youngRoom: Value;
  spacing: Value;
  pixels: Value;
  /** The distance from the nearest old line, pixels. */
  fromOld: Value;
}

/** How lines of a technique cover a pixel. */
interface Covering {
  /** The share that one covers. @param away signed distance from it, pixels @param room half of its room, pixels */
  of(away: Value, room: Value, line: Value, isYoung: Value): Value;
  /** The place of the young line among the three that may touch the pixel. */
  youngAt: Value;
}

function coveringBy(
  technique: HatchingTechnique,
  h: HatchingParameters,
  family: Family,
  tone: Value,
  { octave, oldRoom, youngRoom, spacing, pixels, fromOld }: NearLines,
): Covering {
  if (technique === 'pen') {
    const pen = penFor(h, family, tone, octave);
    const thereYoung = thereOn(pen, youngRoom.div(oldRoom));
    // The line in whose room the pixel lies comes first: in light tones no other touches it.
    const isInYoung = pixels.mul(0.5).sub(fromOld).sub(youngRoom).lessThan(fromOld.sub(oldRoom));
    return {
      of: (away, room, line, isYoung) =>
        penCoverage(pen, line, { away, room, there: select(isYoung, thereYoung, float(1)).toVar(), spacing }),
      youngAt: select(isInYoung, int(0), int(1)).toVar(),
    };
  }
  if (technique === 'woodcut') {
    const cut = cutFor(h, family, tone, octave);
    return {
      of: (away, room, line) => lineCoverage(abs(away), room.mul(cutWidth(cut, line)).toVar(), FRINGE),
      youngAt: int(1),
    };
  }
  return {
    of: (away, room, line) => {
      const ofHand = family.isOfForm ? tone : tone.mul(handWidth(line));
      const width = h.shadowLeft && !family.isOfForm ? ofHand.mul(lineLeft(line, h.shadowLeft)) : ofHand;
      return lineCoverage(abs(away), room.mul(width).toVar(), FRINGE);
    },
    youngAt: int(1),
  };
}

/** Prints the lines of a family, or the rows of strokes of a hand, and returns their darkness. */
export type FamilyPrinter = (h: HatchingParameters, family: Family, tone: Value) => Value;

/** The darkness of a family. */
export function ruledLines(h: HatchingParameters, family: Family, tone: Value, technique: HatchingTechnique): Value {
  const trianglePerPixel = trianglePerPixelOf(family);
  const octave = octaveOf(h, family, trianglePerPixel);
  if (technique === 'woodcut') octave.addAssign(rowOctaves(rowTone(h, tone)));
  octave.assign(min(octave, family.coarsest));
  const period = powerOf2(ceil(octave)).toVar();
  const pixels = period.div(trianglePerPixel).toVar();
  const spacing = powerOf2(octave).div(trianglePerPixel).toVar();
  const x = family.value.div(period).toVar();
  const old = floor(x.add(0.5)).toVar();
  const oldRoom = spacing.mul(0.5).toVar();
  const youngRoom = pixels.sub(spacing).mul(0.5).toVar();
  const fromOld = abs(x.sub(old)).mul(pixels).toVar();
  const near = { octave, oldRoom, youngRoom, spacing, pixels, fromOld };
  const { of, youngAt } = coveringBy(technique, h, family, tone, near);
  const side = select(x.lessThan(old), float(-0.5), float(0.5)).toVar();
  const covered = float(0).toVar();
  // Sums over all lines that may touch the pixel: the nearest old one, the next on the pixel's side, and the young one between.
  Loop({ start: int(0), end: int(3), type: 'int', condition: '<' }, ({ i }) => {
    const isYoung = i.equal(youngAt).toVar();
    const steps = select(isYoung, float(1), select(i.lessThan(int(2)), float(0), float(2)));
    const line = old.add(side.mul(steps)).toVar();
    const room = select(isYoung, youngRoom, oldRoom).toVar();
    covered.addAssign(of(x.sub(line).mul(pixels).toVar(), room, line.mul(period).toVar(), isYoung));
  });
  covered.assign(min(covered, 1));
  return technique === 'woodcut' ? covered.oneMinus() : covered;
}
