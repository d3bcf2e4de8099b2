#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Across the strokes of the light, whichever way they run.
  float shadowLayer(const in HatchingParameters h, const in PerToneNormal tone) {
    return hatchLayer(turnedLayer(h, 3.0, vec2(0.0, 1.0)), tone);
  }
#endif // SHADOW_STROKES
