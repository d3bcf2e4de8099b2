#include "technique/constants"
#include "perFragment/varyings"

#if DIRECTION == DIRECTION_FORM || DIRECTION == DIRECTION_ACROSS_FORM
  #define FOLLOWS_FORM
#endif // DIRECTION

// Field space: that of the object, or one for all objects of a scene, from a common origin and in tiles.
varying vec3 vFieldPoint;
varying vec3 vFieldNormal; // smoothed to the scale of a stroke
varying vec3 vRay; // from the place to the viewer, as long as the depth; of length 1 for orthographic cameras
varying float vViewUnitsPerPixel;
#ifdef FOLLOWS_FORM
  // Gradient of a function, per tile, and its value minus half of the gradient's product with the position.
  varying vec4 vForm;
  varying vec4 vFormCrossing; // of the crossing lines
#elif TONE_MODEL == TONE_MODEL_SHADOW && SHADOW_DIRECTION == SHADOW_DIRECTION_AWAY
  #define RUNS_AWAY
#elif DIRECTION == DIRECTION_LIGHT || DIRECTION == DIRECTION_TOWARDS_LIGHT
  #define TURNS_WITH_LIGHT
  #if !defined(USE_SHADOWMAP) || SHADOW_STROKES != SHADOW_STROKES_REORIENT
    #define FIELD_BY_VERTEX
  #endif // USE_SHADOWMAP
#endif // FOLLOWS_FORM

// Constant over an object.
#ifdef FIELD_BY_VERTEX
  varying vec4 vField; // axis, unit, and curvature of the function whose level sets are lines
  varying vec3 vFieldSide; // a unit vector across the axis
#elif defined(TURNS_WITH_LIGHT) || defined(RUNS_AWAY)
  varying vec4 vFieldLight; // unit direction towards the light, and reciprocal of its distance, 0 for directional lights
#endif // FIELD_BY_VERTEX
