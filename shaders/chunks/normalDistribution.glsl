// Φ, the standard normal distribution, to 2e-4, and its slope.
vec2 normalDistribution(const in float g) {
  float h = 1.0 / (1.0 + exp(-1.5957691216 * (g + 0.044715 * g * g * g)));
  return vec2(h, h * (1.0 - h) * 1.5957691216 * (1.0 + 0.134145 * g * g));
}
