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
#elif TONE_MODEL == TONE_MODEL_SHADOW && SHADOW_DIRECTION == SHADOW_DIRECTION_AWAY
  #define RUNS_AWAY
#elif LINE_FIELD == LINE_FIELD_LIGHT || LINE_FIELD == LINE_FIELD_TOWARDS
  #define TURNS_WITH_LIGHT
  #if !defined(USE_SHADOWMAP) || SHADOW_STROKES != SHADOW_STROKES_REORIENT
    #define FIELD_BY_VERTEX
  #endif // USE_SHADOWMAP
#endif // FOLLOWS_FORM

// The same all over the object.
#ifdef FIELD_BY_VERTEX
  varying vec4 vField; // the axis, unit, and the bend of the function that lines are level sets of
  varying vec3 vFieldSide; // a unit vector across the axis
#elif defined(TURNS_WITH_LIGHT) || defined(RUNS_AWAY)
  varying vec4 vFieldLight; // towards the light, unit; and one over its distance, 0 without an end
#endif // FIELD_BY_VERTEX
