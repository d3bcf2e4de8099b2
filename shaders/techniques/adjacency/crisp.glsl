// The same frames and weights, but the fields are blended, and compared with the tone once.
float hatchLayer(const in HatchingParameters h, const in PerToneNormal tone) {
  // All frames of a triangle have the same scale, so they share one level.
  float crowding;
  ThresholdLevel level = crispLevel(h.uv[0], crowding);
  float g = blendedField(h.uv[0], h.uv[1], h.uv[2], h.uv[3], h.weights, level);
  return inkAt(HatchField(g, level.mixing), blend(h, vec4(tone)), crowding);
}
