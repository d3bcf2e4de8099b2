#include "technique/constants"
#include "perFragment/varyings"

#if LINE_FIELD == LINE_FIELD_FORM || LINE_FIELD == LINE_FIELD_ACROSS_FORM
  #define FOLLOWS_FORM
#endif // LINE_FIELD

// Field space: that of the object, or one for all objects of a scene, from a common origin and in tiles.
varying vec3 vFieldPoint;
varying vec3 vFieldNormal; // at the scale of a stroke
varying float vViewUnitsPerPixel;
#ifdef FOLLOWS_FORM
  // The gradient of a function, per tile, and its value less half of what the gradient makes of the place.
  varying vec4 vForm;
  varying vec4 vFormCrossing; // of the lines that cross
#else
  varying vec4 vFieldLight; // towards the light, unit; and one over its distance, 0 without an end; the same all over the object
#endif // FOLLOWS_FORM
