// Strokes in shadows.
#if defined(SEPARATES_SHADOWS) && SHADOW_STROKES != SHADOW_STROKES_TONE
  #include "technique/shadowStrokes"
#endif // SEPARATES_SHADOWS

float hatchInShadow(const in HatchingParameters h, const in PerToneNormal tone, const in HatchingSurface surface) {
  // Dots cannot cross one another: two sets of them would clump.
  #if defined(SEPARATES_SHADOWS) && SHADOW_STROKES == SHADOW_STROKES_CROSS && TECHNIQUE != TECHNIQUE_STIPPLE
    // The strokes of the light run on through the shadow, which is a layer over them that adds what the tone lacks: 1 − (1 − T)/(1 −
    // T_unshadowed).
    PerToneNormal unshadowed = faded(unshadowedTone(surface));
    return 1.0 - (1.0 - hatch(h, unshadowed)) * (1.0 - shadowLayer(h, leftOf(tone, unshadowed)));
  #else
    return hatch(h, tone);
  #endif // SEPARATES_SHADOWS
}
