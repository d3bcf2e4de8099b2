// The same frames and weights, but what is blended is the field, and ink is decided once.
float hatchLayer(const in HatchingParameters h, const in PerToneNormal tone) {
  // All frames of a triangle have the same scale, so one choice of level serves them all.
  float crowding;
  ThresholdLevel level = crispLevel(h.uv[0], crowding);
  float g = blendedField(h.uv[0], h.uv[1], h.uv[2], h.uv[3], h.weights, level);
  return inkAt(HatchField(g, level.mixing), blend(h, vec4(tone)), crowding);
}
