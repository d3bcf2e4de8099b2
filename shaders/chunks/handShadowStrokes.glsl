// Strokes of a hand in shadows, in the place of shadowStrokes.glsl.
#if defined(SEPARATES_SHADOWS) && SHADOW_STROKES != SHADOW_STROKES_TONE
  #include "technique/shadowStrokes"
#endif // SEPARATES_SHADOWS

float hatchInShadow(const in HatchingParameters h, const in float tone, const in HatchingSurface surface) {
  #ifdef SHADOWS_ALONG_STROKES
    vec2 tones = tonesOfShadows(surface);
  #else
    float tones = tone;
  #endif // SHADOWS_ALONG_STROKES
  #if defined(SEPARATES_SHADOWS) && SHADOW_STROKES == SHADOW_STROKES_CROSS
    // The strokes of the light run on through the shadow.
    float unshadowed = faded(unshadowedTone(surface));
    return 1.0 - (1.0 - hatch(h, unshadowed)) * (1.0 - shadowLayer(h, leftOf(tones, Tones(unshadowed))));
  #else
    return hatchLayer(h, tones);
  #endif // SEPARATES_SHADOWS
}
