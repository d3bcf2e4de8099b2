// The unsteadiness of a hand. It belongs to the place on the object: nothing moves when the camera does.
uniform float handmade; // 0: a ruling machine

// Slow waves without a period in sight, each within [−1, 1].
vec3 slowWaves(const in vec3 p) {
  vec3 bent = p + 0.7 * sin(1.7 * p.yzx + vec3(0.3, 2.1, 4.4));
  return sin(2.3 * bent.zxy + vec3(1.1, 3.7, 5.2));
}

// How far lines stray, in tiles.
#define STRAY 0.012

vec3 handPoint(const in vec3 point) {
  return point + handmade * STRAY / strokeScale * slowWaves(3.0 * strokeScale * point);
}

// Pressure comes and goes along a line; where the tone is light it lifts, and leaves gaps.
float handPressure(const in vec3 point) {
  vec3 waves = slowWaves(5.0 * strokeScale * point + 7.0);
  return handmade * 0.45 * waves.x * waves.y;
}

float handTone(const in float pressure, const in float tone) {
  return tone + pressure * tone * (1.0 - tone);
}

// A factor on the width of a line, the same all along it; 1 in the mean.
float handWidth(const in float line) {
  uint h = floatBitsToUint(line) * 0x9e3779b9u;
  h ^= h >> 16u;
  h *= 0x7feb352du;
  h ^= h >> 15u;
  return 1.0 + handmade * 0.25 * (float(h >> 8u) / 8388608.0 - 1.0);
}
