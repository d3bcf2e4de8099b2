/** Counterpart of shaders/techniques/lines/ruledLines.glsl: one family of lines. */
import { GROUND_CONSTANTS } from '../../../look/constants/lineConstants.js';
import type { HatchingTechnique } from '../../../look/hatchingProperties.js';
import { lineCoverage } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { cutFor, cutWidth, rowOctaves } from './carving.js';
import { handWidth, hash01 } from './hand.js';
import { penCoverage, penFor } from './penStrokes.js';
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

/**
 * The share of a pixel that a line covers. @param away signed distance from the line, pixels @param room half of the room of the line,
 * pixels
 */
type Covering = (away: Value, room: Value, line: Value) => Value;

function coveringBy(
  technique: HatchingTechnique,
  h: HatchingParameters,
  family: Family,
  tone: Value,
  { octave, oldRoom, spacing }: Record<'octave' | 'oldRoom' | 'spacing', Value>,
): Covering {
  if (technique === 'pen') {
    const pen = penFor(h, family, tone, octave);
    return (away, room, line) => penCoverage(pen, away, room.div(oldRoom), spacing, line);
  }
  if (technique === 'woodcut') {
    const cut = cutFor(h, family, tone, octave);
    return (away, room, line) => lineCoverage(abs(away), room.mul(cutWidth(cut, line)).toVar(), FRINGE);
  }
  return (away, room, line) => {
    const ofHand = family.isOfForm ? tone : tone.mul(handWidth(line));
    const width = h.shadowLeft && !family.isOfForm ? ofHand.mul(lineLeft(line, h.shadowLeft)) : ofHand;
    return lineCoverage(abs(away), room.mul(width).toVar(), FRINGE);
  };
}

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
  const below = floor(x).toVar();
  const oldRoom = spacing.mul(0.5).toVar();
  const youngRoom = pixels.sub(spacing).mul(0.5).toVar();
  const covering = coveringBy(technique, h, family, tone, { octave, oldRoom, spacing });
  const covered = float(0).toVar();
  // Sums over all lines that may touch the pixel.
  Loop({ start: int(0), end: int(3), type: 'int', condition: '<' }, ({ i }) => {
    const line = below.add(float(i).mul(0.5)).toVar();
    const room = select(i.equal(int(1)), youngRoom, oldRoom).toVar();
    covered.addAssign(covering(x.sub(line).mul(pixels).toVar(), room, line.mul(period).toVar()));
  });
  covered.assign(min(covered, 1));
  return technique === 'woodcut' ? covered.oneMinus() : covered;
}
