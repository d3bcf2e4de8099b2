/** Counterpart of shaders/techniques/lines/hand.glsl: the unsteadiness of a hand. */
import { HAND_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { HASH_FACTORS } from '../../../look/constants/patternConstants.js';
import { hatchingUniform } from '../base/uniforms.js';
import { type Input, tsl, type Value } from '../base/values.js';

const { abs, float, floatBitsToUint, fract, select, uint, vec3 } = tsl;
const { BEND_PHASES, BENDS, BENT_BY, PRESSURE, SLOW_WAVES, STRAY, WAVE_PHASES, WIDTHS } = HAND_CONSTANTS;

export const irregularity: Value = /* @__PURE__ */ hatchingUniform('irregularity', 'float');

const halfOf = (numbers: readonly number[]): Value => {
  const [x, y, z] = numbers.map((number) => 0.5 * number);
  return vec3(x, y, z);
};

function wave(halfX: Value): Value {
  const t = fract(halfX).mul(2).sub(1).toVar();
  return t.mul(abs(t).mul(4).sub(4));
}

/** Slow waves, each within [−1, 1], without a visible period. */
export function slowWaves(p: Value): Value {
  const bends = wave(
    vec3(p.y, p.z, p.x)
      .mul(0.5 * BENDS)
      .add(halfOf(BEND_PHASES)),
  );
  const bent = p.add(bends.mul(BENT_BY)).toVar();
  return wave(
    vec3(bent.z, bent.x, bent.y)
      .mul(0.5 * SLOW_WAVES)
      .add(halfOf(WAVE_PHASES)),
  );
}

export const handPoint = (point: Value, waves: Value): Value => point.add(waves.mul(irregularity.mul(STRAY)));

export const handPressure = (waves: Value): Value => irregularity.mul(PRESSURE).mul(waves.x).mul(waves.y);

export const handTone = (pressure: Value, tone: Value): Value => tone.add(pressure.mul(tone).mul(tone.oneMinus()));

/** 24 random bits of a line, above eight others. @param line its value, a multiple of a power of two */
export function lineBits(digits: number, line: Value): Value {
  const bits = floatBitsToUint(line).toVar();
  const exponent = bits.shiftRight(uint(23)).bitAnd(uint(31)).toVar();
  const rest = uint(32).sub(exponent).bitAnd(uint(31));
  const factor = uint(digits).shiftLeft(exponent).bitOr(uint(digits).shiftRight(rest));
  const significand = bits.bitAnd(uint(0x7fffff)).bitOr(uint(0x800000));
  return significand.mul(factor).bitXor(bits.bitAnd(uint(0x80000000)));
}

/** A hash of a line in [0, 1). */
const hashBy = (digits: number, line: Value): Value =>
  float(lineBits(digits, line).shiftRight(uint(8) as Input)).mul(1 / 16777216);

/** A hash of a line, far from those of its neighbours. */
export const hash01 = (line: Value): Value => hashBy(HASH_FACTORS.THUE_MORSE, line);

/** A hash of a line that is 0, a third or two thirds for three neighbours. */
export const turnOf = (line: Value): Value => select(line.equal(0), 0, hashBy(HASH_FACTORS.ONE_THIRD, line)).toVar();

/** A factor on the width of a whole line; 1 in the mean. */
export function handWidth(line: Value): Value {
  const most = irregularity.mul(WIDTHS);
  return most.mul(hash01(line)).add(most.mul(0.5).oneMinus());
}
