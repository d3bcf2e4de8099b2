float hatchLayer(const in HatchingParameters h, const in float tone) {
  return 1.0 - lightnessOfHatch(h.uv, tone);
}
