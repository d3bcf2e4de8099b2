#include "turnedShadowLayer"

#ifdef REORIENTS_IN_SHADOW
  #define TURNS_IN_SHADOW

  // Frames are computed per vertex, before shadows are known: where shadows take most of the light, strokes turn by a right angle.
  HatchingParameters turnedInShadow(const in HatchingParameters h) {
    if (lightTaken <= LEAST_RESPONSE * lightSent) return h;
    return turnedLayer(h, 0.0, vec2(0.0, 1.0));
  }
#endif // REORIENTS_IN_SHADOW
