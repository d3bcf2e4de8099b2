vec3 neighbourWeights(const in HatchingParameters h) {
  return h.weights.yzw;
}

float meanTone(const in HatchingParameters h, const in PerToneNormal tone) {
  return blend(h, vec4(tone));
}

// In the frame of c.
vec2 frameUv(const in HatchingParameters h) {
  return h.uv[0];
}
