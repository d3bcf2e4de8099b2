#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Always across the strokes of the light, whichever way they run.
  float shadowLayer(const in HatchingParameters h, const in PerToneNormal tone) {
    return hatchLayer(turnedLayer(h, 3.0, vec2(0.0, 1.0)), tone);
  }
#else
  // Frames are made per vertex, before shadows are known: where they take most of the light, strokes are turned by a right angle.
  HatchingParameters reorientedInShadow(const in HatchingParameters h) {
    if (lightTaken <= LEAST_RESPONSE * lightSent) return h;
    return turnedLayer(h, 0.0, vec2(0.0, 1.0));
  }
#endif // SHADOW_STROKES
