// Weights of neighbours for debug views of techniques that do not blend.
vec3 neighbourWeights(const in HatchingParameters h) {
  return vec3(0.0);
}

float meanTone(const in HatchingParameters h, const in float tone) {
  return tone;
}
