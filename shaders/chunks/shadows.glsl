// Shadows as something that strokes know of. three hands over light that shadows have dimmed; here the two are told apart.
#if defined(USE_SHADOWMAP) && (SHADOW_STROKES != SHADOW_STROKES_TONE || TONE_MODEL == TONE_MODEL_SHADOW)
  #define TELLS_SHADOWS

  float lightShadow = 1.0; // of the light at hand: 1 where all of it arrives, 0 where nothing does

  float tellShadow(const in float shadow) {
    lightShadow = shadow;
    return 1.0;
  }

  #include "lightShadows"

  #if SHADOW_STROKES == SHADOW_STROKES_REORIENT
    #define REORIENTS_IN_SHADOW

    // In three's order.
    bool isLightShadowed[LIGHTS_WITH_DIRECTION];
    int lightsMet = 0;
    float lightSent = 0.0; // of all lights together, but for shadows
    float lightTaken = 0.0; // what shadows take of it, less what they leave

    // Where a surface hardly sees a light, whether it lies in shadow is a matter of rounding.
    #define LEAST_RESPONSE 0.05
  #endif // SHADOW_STROKES
#endif // USE_SHADOWMAP
