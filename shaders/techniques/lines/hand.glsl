// The unsteadiness of a hand. It is fixed to the object, so that nothing moves with the camera.
uniform float irregularity; // 0: lines as by a ruling machine

#include "technique/steadiness"

#ifdef STEADY
  vec3 slowWaves(const in vec3 p) {
    return vec3(0.0);
  }

  vec3 handPoint(const in vec3 point, const in vec3 waves) {
    return point;
  }

  float handPressure(const in vec3 waves) {
    return 0.0;
  }

  float handTone(const in float pressure, const in float tone) {
    return tone;
  }
#else
  // A wave of period 2 within [−1, 1]: two parabolas, smooth and far cheaper than a sine. halfX: half of the coordinate.
  vec3 wave(const in vec3 halfX) {
    vec3 t = 2.0 * fract(halfX) - 1.0;
    return t * (4.0 * abs(t) - 4.0);
  }

  // Slow waves, each within [−1, 1], without a visible period.
  vec3 slowWaves(const in vec3 p) {
    vec3 bent = p + BENT_BY * wave(0.5 * BENDS * p.yzx + 0.5 * BEND_PHASES);
    return wave(0.5 * SLOW_WAVES * bent.zxy + 0.5 * WAVE_PHASES);
  }

  // A point, displaced by the hand.
  vec3 handPoint(const in vec3 point, const in vec3 waves) {
    return point + irregularity * STRAY * waves;
  }

  // Pressure varies along a line; in light tones the hand lifts, and leaves gaps.
  float handPressure(const in vec3 waves) {
    return irregularity * PRESSURE * waves.x * waves.y;
  }

  float handTone(const in float pressure, const in float tone) {
    return tone + pressure * tone * (1.0 - tone);
  }
#endif // STEADY

// 24 random bits of a line, above eight others. line: its value, a multiple of a power of two. It is multiplied by a number whose binary digits repeat the
// given ones on both sides of the point, and the fraction has the bits.
uint lineBits(const in uint digits, const in float line) {
  uint bits = floatBitsToUint(line);
  uint exponent = (bits >> 23u) & 31u;
  uint factor = (digits << exponent) | (digits >> ((32u - exponent) & 31u));
  return (((bits & 0x7fffffu) | 0x800000u) * factor) ^ (bits & 0x80000000u);
}

// A hash of a line in [0, 1).
float hashBy(const in uint digits, const in float line) {
  return float(lineBits(digits, line) >> 8u) * (1.0 / 16777216.0);
}

// A hash of a line, far from those of its neighbours.
float hash01(const in float line) {
  return hashBy(THUE_MORSE, line);
}

// A hash of a line that is 0, a third or two thirds for three neighbours.
float turnOf(const in float line) {
  return line == 0.0 ? 0.0 : hashBy(ONE_THIRD, line);
}

// A factor on the width of a whole line; 1 in the mean.
float handWidth(const in float line) {
  float most = irregularity * WIDTHS;
  return most * hash01(line) + (1.0 - 0.5 * most);
}
