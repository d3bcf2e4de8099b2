// Strokes in shadows.
#ifdef SHADOWS_ALONG_STROKES
  // The tones without the shadows that are read along strokes, and in all of them.
  vec2 tonesOfShadows(const in HatchingSurface surface) {
    sumCastLight(-vViewPosition);
    vec2 sent = openToLights() * castHere;
    vec2 tones;
    for (int i = 0; i < 2; i++) {
      float radiance = surface.radiance - sent.y + (i == 0 ? sent.x : 0.0);
      tones[i] = faded(deepened(darkenedByColor(toneFromRadiance(exposed(radiance)), surface)));
    }
    return tones;
  }
#endif // SHADOWS_ALONG_STROKES

#if defined(SEPARATES_SHADOWS) && SHADOW_STROKES != SHADOW_STROKES_TONE
  #include "technique/shadowStrokes"
#endif // SEPARATES_SHADOWS

float hatchInShadow(const in HatchingParameters h, const in PerToneNormal tone, const in HatchingSurface surface) {
  // Dots cannot cross one another: two sets of them would clump.
  #if defined(SEPARATES_SHADOWS) && SHADOW_STROKES == SHADOW_STROKES_CROSS && TECHNIQUE != TECHNIQUE_STIPPLE
    // The strokes of the light run on through the shadow, which is a layer over them that adds what the tone lacks: 1 − (1 − T)/(1 −
    // T_unshadowed).
    PerToneNormal unshadowed = faded(unshadowedTone(surface));
    #ifdef SHADOWS_ALONG_STROKES
      vec2 tones = tonesOfShadows(surface);
      vec2 left = vec2(leftOf(tones.x, unshadowed), leftOf(tones.y, unshadowed));
    #else
      PerToneNormal left = leftOf(tone, unshadowed);
    #endif // SHADOWS_ALONG_STROKES
    return 1.0 - (1.0 - hatch(h, unshadowed)) * (1.0 - shadowLayer(h, left));
  #elif defined(SHADOWS_ALONG_STROKES)
    return hatchLayer(h, tonesOfShadows(surface));
  #else
    return hatch(h, tone);
  #endif // SEPARATES_SHADOWS
}
