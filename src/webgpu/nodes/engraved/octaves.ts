/** Counterpart of `octaves` and `powerOf2` in shaders/techniques/engraved/ruledLines.glsl. */
import { tsl, type Value } from '../base/values.js';

const { float, floatBitsToInt, int, intBitsToFloat } = tsl;

/** An approximate logarithm to base 2: exact at powers of two, linear between them. @param x above 0, a variable */
export const octaves = (x: Value): Value =>
  float(floatBitsToInt(x))
    .mul(1 / 8388608)
    .sub(127);

/** The inverse of `octaves`. */
export const powerOf2 = (octave: Value): Value => intBitsToFloat(int(octave.mul(8388608).add(1065353216)));
