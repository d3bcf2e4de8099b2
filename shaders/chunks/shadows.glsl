// Separates a light from its shadow, since strokes depend on both. three.js' chunks multiply the two.
#if defined(USE_SHADOWMAP) && (SHADOW_STROKES != SHADOW_STROKES_TONE || TONE_MODEL == TONE_MODEL_SHADOW || defined(SHADOWS_ALONG_STROKES))
  #define SEPARATES_SHADOWS

  float lightShadow = 1.0; // of the current light: 1 where all of it arrives, 0 where nothing does
  int lightsVisited = 0; // lights visited so far by three.js' chunk

  float separateShadow(const in float shadow) {
    lightShadow = shadow;
    return 1.0;
  }

  // The shadow of the current light, from three.js' function unless it is known already.
  #if TONE_MODEL == TONE_MODEL_SHADOW
    #define KNOWN_SHADOW(shadow) (passing[lightsVisited] < 0.0 ? shadow : passing[lightsVisited])
  #else
    #define KNOWN_SHADOW(shadow) shadow
  #endif // TONE_MODEL
  #include "lightShadows"

  #if SHADOW_STROKES == SHADOW_STROKES_REORIENT
    #define REORIENTS_IN_SHADOW

    // By the number of the light, written as three.js' chunk visits it.
    bool isLightShadowed[LIGHTS_WITH_DIRECTION];
    float lightSent = 0.0; // luminance of all lights, without shadows
    float lightTaken = 0.0; // luminance that shadows take
  #endif // SHADOW_STROKES
#endif // USE_SHADOWMAP
