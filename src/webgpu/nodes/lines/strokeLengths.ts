/** Spacing of lines in octaves, and the strokes that lines are drawn in. */
import { LINE_CONSTANTS, STROKE_LENGTH_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { HASH_FACTORS } from '../../../look/constants/patternConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { screenGradient } from '../chunks/screenGradient.js';
import { vFieldNormal, vFieldPoint } from './fields.js';
import type { Family, HatchingParameters } from './read.js';

const {
  abs,
  ceil,
  clamp,
  cross,
  dot,
  float,
  floatBitsToInt,
  floatBitsToUint,
  floor,
  int,
  intBitsToFloat,
  max,
  min,
  mix,
} = tsl;
const { normalize, select, smoothstep, uint, vec2, vec3 } = tsl;
const { AXES_FADE, DIFFERING_OCTAVES, LEAST_DIFFERING, LENGTHS_FADE } = STROKE_LENGTH_CONSTANTS;

export const screenSpaceShare: Value = /* @__PURE__ */ hatchingUniform('screenSpaceShare', 'float');

/** Counterpart of shaders/techniques/lines/lineSpacing.glsl: how far the lines of a family lie apart. */

const lineSpacing = /* @__PURE__ */ hatchingUniform('lineSpacing', 'float');
const shadowSpacing = /* @__PURE__ */ hatchingUniform('shadowSpacing', 'float');
const minLineSpacing = /* @__PURE__ */ hatchingUniform('minLineSpacing', 'float');

/** Width over which the edge of a line fades, pixels. */
export const FRINGE = 0.5;

/** An approximate logarithm to base 2: exact at powers of two, linear between them. @param x above 0, a variable */
export const octaves = (x: Value): Value =>
  float(floatBitsToInt(x))
    .mul(1 / 8388608)
    .sub(127);

/** The inverse of `octaves`. */
export const powerOf2 = (octave: Value): Value => intBitsToFloat(int(octave.mul(8388608).add(1065353216)));

/** The change of a family's function from one pixel to the next on the flat triangle, above 0. */
export function trianglePerPixelOf(family: Family): Value {
  const { LEAST_OF_SMOOTH } = LINE_CONSTANTS;
  return max(family.trianglePerPixel, max(family.perPixel.mul(LEAST_OF_SMOOTH), 1e-12)).toVar();
}

/** The octave of the distance between its lines, before repeats of their numbers limit it. */
export function octaveOf(h: HatchingParameters, family: Family, trianglePerPixel: Value): Value {
  const { MOST_OFF_TRIANGLE, PARTS_OF_TILE } = LINE_CONSTANTS;
  const perPixel = clamp(
    family.perPixel,
    trianglePerPixel.div(MOST_OFF_TRIANGLE),
    trianglePerPixel.mul(MOST_OFF_TRIANGLE),
  ).toVar();
  const wanted = h.shadowLeft ? lineSpacing.mul(shadowSpacing).toVar() : lineSpacing;
  const onObject = octaves(wanted.div(PARTS_OF_TILE).mul(family.rise).toVar());
  const onScreen = octaves(wanted.mul(perPixel).toVar());
  return max(mix(onObject, onScreen, screenSpaceShare), octaves(minLineSpacing.mul(perPixel).toVar())).toVar();
}

/** Counterpart of shaders/techniques/lines/strokeLengths.glsl: the strokes that the lines of a family are drawn in. */

export const strokeLength: Value = /* @__PURE__ */ hatchingUniform('strokeLength', 'float');

/** The coordinates of a fragment along the lines of a family: on the two axes of the field along which the lines run most. */
export interface Along {
  /** The axes. */
  first: Value;
  second: Value;
  places: Value;
  /** Share of the first axis. */
  share: Value;
  /** Length of a stroke with its gap. */
  period: Value;
  /** Share of strokes twice as long. */
  longer: Value;
}

export const crossed = (a: Value, b: Value): Value => abs(a.x.mul(b.y).sub(a.y.mul(b.x)));

export function alongLines(h: HatchingParameters, family: Family): Along {
  const direction = cross(vFieldNormal, family.gradient).toVar();
  const squares = direction.mul(direction).toVar();
  squares.assign(squares.div(max(squares.x.add(squares.y).add(squares.z), 1e-20)));
  // The axis along which the lines run least is left out.
  const isLeastX = squares.x.lessThan(min(squares.y, squares.z)).toVar();
  const isLeastY = squares.y.lessThan(squares.z);
  const first = select(isLeastX, vec3(0, 0, 1), vec3(1, 0, 0)).toVar();
  const second = select(isLeastX.not().and(isLeastY), vec3(0, 0, 1), vec3(0, 1, 0)).toVar();
  const share = smoothstep(-AXES_FADE, AXES_FADE, dot(squares, first.sub(second))).toVar();
  const value = normalize(screenGradient(family.gradient, h.onScreen)).toVar();
  const acrossFirst = crossed(screenGradient(first, h.onScreen).toVar(), value);
  const acrossSecond = crossed(screenGradient(second, h.onScreen).toVar(), value);
  const perPixel = mix(acrossSecond, acrossFirst, share);
  const onObject = octaves(strokeLength.div(LINE_CONSTANTS.PARTS_OF_TILE).toVar());
  const onScreen = octaves(strokeLength.mul(max(perPixel, 1e-12)).toVar());
  const octave = mix(onObject, onScreen, screenSpaceShare).toVar();
  const whole = ceil(octave.sub(0.5)).toVar();
  return {
    first,
    second,
    places: vec2(dot(first, vFieldPoint), dot(second, vFieldPoint)).toVar(),
    share,
    period: powerOf2(whole).toVar(),
    longer: smoothstep(1 - LENGTHS_FADE, 1, octave.sub(whole).add(0.5)).toVar(),
  };
}

/**
 * The amplitude of variation from line to line, as a share of the greatest: less if few lines lie between repeats of their numbers. @param
 * octave of their spacing
 */
export const differing = ({ coarsest }: Family, octave: Value): Value =>
  clamp(float(coarsest).sub(octave).div(DIFFERING_OCTAVES), LEAST_DIFFERING, 1).toVar();

/** The number of a line: the same on both sides of a seam, except for its sign. */
export function numberOf(line: Value, { isOfForm, coarsest }: Family): Value {
  if (!isOfForm) return line;
  const repeat = powerOf2(float(coarsest).toVar()).toVar();
  return line.sub(repeat.mul(floor(line.div(repeat).add(0.5)))).toVar();
}

/** Counterpart of shaders/techniques/lines/strokeHashes.glsl: random numbers of strokes. */

/** Random bits of a line, from which the hashes of its strokes are made. */
export function bitsOfLine(line: Value): Value {
  const { GOLDEN_RATIO, THIRD_FACTOR } = HASH_FACTORS;
  const word = floatBitsToUint(line).toVar();
  const spread = word
    .bitXor(word.shiftRight(uint(12)))
    .mul(uint(GOLDEN_RATIO))
    .toVar();
  return spread
    .bitXor(spread.shiftRight(uint(13)))
    .mul(uint(THIRD_FACTOR))
    .toVar();
}

/** A hash of a stroke in [0, 1), far from those of its neighbours on the line. */
export const strokeHash01 = (bits: Value, stroke: Value): Value =>
  float(bits.add(uint(int(stroke)).mul(uint(HASH_FACTORS.THUE_MORSE))).shiftRight(uint(8)))
    .div(16777216)
    .toVar();
