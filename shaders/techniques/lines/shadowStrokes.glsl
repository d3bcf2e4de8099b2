#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Families that lean back, across the first family and across those of its darks.
  float shadowLayer(const in HatchingParameters h, const in Tones tone) {
    return contrasted(tone, families(h, Tones(0.0), tone, -layerTurns.zw));
  }
#endif // SHADOW_STROKES
