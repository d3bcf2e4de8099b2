float hatchLayer(const in HatchingParameters h, const in float tone) {
  float crowding;
  ThresholdLevel level = crispLevel(h.uv, crowding);
  return inkAt(HatchField(thresholdAt(h.uv, level), level.mixing), tone, crowding);
}
