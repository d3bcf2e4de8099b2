#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Always across the strokes of the light, whichever way they run.
  float shadowLayer(const in HatchingParameters h, const in PerToneNormal tone) {
    return hatchLayer(turnedLayer(h, 3.0, vec2(0.0, 1.0)), tone);
  }
#else
  // The frame was made of the lights that arrive.
  HatchingParameters reorientedInShadow(const in HatchingParameters h) {
    return h;
  }
#endif // SHADOW_STROKES
