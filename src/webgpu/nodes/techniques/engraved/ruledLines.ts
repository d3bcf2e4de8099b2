/** The twin of shaders/techniques/engraved/ruledLines.glsl: one family of lines. */
import { LINE_CONSTANTS } from '../../../../engraving/constants/lineConstants.js';
import { lineCoverage } from '../../chunks/lineCoverage.js';
import { hatchingUniform } from '../../uniforms.js';
import { tsl, type Value } from '../../values.js';
import { handWidth } from './hand.js';

const { abs, ceil, float, floatBitsToInt, floor, int, intBitsToFloat, max, min, mix } = tsl;

/** Pixels between lines, or 256ths of a tile. */
const lineSpacing = /* @__PURE__ */ hatchingUniform('lineSpacing', 'float');
/** Pixels: where lines would lie closer, every other one is left out. */
const finestSpacing = /* @__PURE__ */ hatchingUniform('finestSpacing', 'float');
const sizedOnScreen = /* @__PURE__ */ hatchingUniform('sizedOnScreen', 'float');

/** How far the edge of a line fades, in pixels. */
const FRINGE = 0.5;

/** Lines that are level sets of one function. */
export interface Family {
  value: Value;
  /** Its change from one pixel to the next. */
  perPixel: Value;
  /** Its change along the surface, per tile, by which lines are spaced on the object. */
  rise: Value;
  /** The octave of the lines that lie farthest apart. */
  coarsest: number;
  /** Whether the number of a line changes across the seams of a bake. */
  isOfForm?: boolean;
}

/** The logarithm to base 2 at powers of two, and linear between them. @param x above 0 */
const octaves = (x: Value): Value =>
  float(floatBitsToInt(x))
    .mul(1 / 8388608)
    .sub(127);

/** The inverse. */
const powerOf2 = (octave: Value): Value => intBitsToFloat(int(octave.mul(8388608).add(1065353216)));

/** The darkness of a family. */
export function ruledLines(family: Family, tone: Value): Value {
  const perPixel = max(family.perPixel, 1e-12).toVar();
  const onObject = octaves(lineSpacing.div(LINE_CONSTANTS.PARTS_OF_TILE).mul(family.rise).toVar());
  const onScreen = octaves(lineSpacing.mul(perPixel).toVar());
  const octave = max(mix(onObject, onScreen, sizedOnScreen), octaves(finestSpacing.mul(perPixel).toVar())).toVar();
  octave.assign(min(octave, family.coarsest));
  const period = powerOf2(ceil(octave)).toVar();
  const pixels = period.div(perPixel).toVar();
  const spacing = powerOf2(octave).div(perPixel).toVar();
  const x = family.value.div(period).toVar();
  const below = floor(x).toVar();
  const rooms = [spacing.mul(0.5), pixels.sub(spacing).mul(0.5)];
  const covered = float(0).toVar();
  // All that a pixel may lie on: their shares of it add up.
  for (let i = 0; i < 3; i++) {
    const line = below.add(0.5 * i).toVar();
    const width = family.isOfForm ? tone : tone.mul(handWidth(line.mul(period).toVar()));
    covered.addAssign(lineCoverage(abs(x.sub(line).mul(pixels)), rooms[i % 2].mul(width), FRINGE));
  }
  return min(covered, 1);
}
