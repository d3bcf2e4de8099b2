#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Families that lean back, across the first family and across those of its darks.
  float shadowLayer(const in HatchingParameters h, const in Tones tone) {
    float darkness = families(h, Tones(0.0), tone, -layerTurns.zw);
    float here = toneHere(tone);
    return here >= 1.0 ? 1.0 : mix(here, darkness, lineContrast);
  }
#endif // SHADOW_STROKES
