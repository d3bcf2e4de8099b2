// Tells the light of a lamp from its shadow, because strokes need to know both. three's chunks multiply the two.
#if defined(USE_SHADOWMAP) && (SHADOW_STROKES != SHADOW_STROKES_TONE || TONE_MODEL == TONE_MODEL_SHADOW)
  #define TELLS_SHADOWS

  float lightShadow = 1.0; // of the light at hand: 1 where all of it arrives, 0 where nothing does
  int lightsMet = 0; // as three's chunk walks over them

  float tellShadow(const in float shadow) {
    lightShadow = shadow;
    return 1.0;
  }

  // Tells of the light at hand by a function of three's, unless we know it already.
  #if TONE_MODEL == TONE_MODEL_SHADOW
    #define KNOWN_SHADOW(shadow) (passing[lightsMet] < 0.0 ? shadow : passing[lightsMet])
  #else
    #define KNOWN_SHADOW(shadow) shadow
  #endif // TONE_MODEL
  #include "lightShadows"

  #if SHADOW_STROKES == SHADOW_STROKES_REORIENT
    #define REORIENTS_IN_SHADOW

    // Noted as three's chunk walks over the lights, by their number.
    bool isLightShadowed[LIGHTS_WITH_DIRECTION];
    float lightSent = 0.0; // luminance of all lights together, without their shadows
    float lightTaken = 0.0; // what shadows take of it, less what they let pass
  #endif // SHADOW_STROKES
#endif // USE_SHADOWMAP
