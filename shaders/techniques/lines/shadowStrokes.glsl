#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Families that lean back, across the first family and across those of its darks.
  float shadowLayer(const in HatchingParameters h, const in float tone) {
    float darkness = families(h, 0.0, tone, -layerTurns.zw);
    return tone >= 1.0 ? 1.0 : mix(tone, darkness, lineContrast);
  }
#endif // SHADOW_STROKES
