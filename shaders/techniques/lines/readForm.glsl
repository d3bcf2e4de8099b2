// Lines that follow the form: level sets of two functions that are baked into the vertices. A function is quadratic within a triangle, so
// that lines have no kinks at edges. Across the seams of the bake it changes by a multiple of a power of two, or in sign: lines no farther
// apart than that run on.
#include "perFragment/fullShadow"

struct HatchingParameters {
  float pressure; // of the hand
  float firstShare; // the first family has lines everywhere
  mat2x3 onScreen, triangle; // of the smooth surface, and of the flat triangle
  vec3 gradient, crossingGradient; // of the first family's function, and of the crossing one
  vec2 values;
  vec2 valueOnScreen; // their gradients on the screen
  vec2 crossingOnScreen;
  vec2 rises; // their changes along the surface, per tile
  float shareB; // a single family crosses
  vec2 coarsest; // octaves of both beyond which lines would not run on across seams
};

float formValueAt(const in vec4 form, const in vec3 stray) {
  return form.w + dot(form.xyz, 0.5 * vFieldPoint + stray);
}

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  vec4 first = vForm;
  vec4 crossing = vFormCrossing;
  #if DIRECTION == DIRECTION_ACROSS_FORM
    h.coarsest = COARSEST_OCTAVES.yx;
  #else
    h.coarsest = COARSEST_OCTAVES;
  #endif // DIRECTION
  #ifdef REORIENTS_IN_SHADOW
    // The families change places where no light arrives.
    if (isInFullShadow()) {
      first = vFormCrossing;
      crossing = vForm;
      h.coarsest = h.coarsest.yx;
    }
  #endif // REORIENTS_IN_SHADOW
  vec3 waves = slowWaves(HAND_WAVES * vFieldPoint);
  vec3 stray = handPoint(vec3(0.0), waves);
  h.pressure = handPressure(waves);
  #if TECHNIQUE != TECHNIQUE_PEN && TECHNIQUE != TECHNIQUE_WOODCUT
    // Strokes and cuts have variations of their own.
    h.pressure += irregularity * WIDTH_WAVE * waves.z;
  #endif // TECHNIQUE
  h.firstShare = 1.0;
  h.values = vec2(formValueAt(first, stray), formValueAt(crossing, stray));
  h.gradient = first.xyz;
  h.crossingGradient = crossing.xyz;
  h.onScreen = smoothOnScreen();
  h.triangle = triangleOnScreen();
  h.valueOnScreen = screenGradient(first.xyz, h.onScreen);
  h.crossingOnScreen = screenGradient(crossing.xyz, h.onScreen);
  h.rises = vec2(length(first.xyz), length(crossing.xyz));
  h.shareB = 1.0;
  return h;
}

Family firstFamily(const in HatchingParameters h) {
  float trianglePerPixel = length(screenGradient(h.gradient, h.triangle));
  return Family(h.values.x, length(h.valueOnScreen), trianglePerPixel, h.rises.x, h.gradient, h.coarsest.x);
}

// lean: cosine and sine of the angle; a negative sine leans the other way. The difference of the two functions is whole across seams too,
// and its lines lean the other way: exactly so at 60°, in the middle between the families at 90°.
Family crossingFamily(const in HatchingParameters h, const in bool isB, const in vec2 lean) {
  bool isOther = lean.y < 0.0;
  float value = isOther ? h.values.x - h.values.y : h.values.y;
  vec2 onScreen = isOther ? h.valueOnScreen - h.crossingOnScreen : h.crossingOnScreen;
  vec3 gradient = isOther ? h.gradient - h.crossingGradient : h.crossingGradient;
  float coarsest = isOther ? min(h.coarsest.x, h.coarsest.y) : h.coarsest.y;
  float trianglePerPixel = length(screenGradient(gradient, h.triangle));
  return Family(value, length(onScreen), trianglePerPixel, h.rises.y, gradient, coarsest);
}

vec2 fieldUv(const in HatchingParameters h) {
  return h.values.yx;
}
