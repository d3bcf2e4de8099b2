#include "perFragment/varyings"

varying vec3 vRestPosition; // object space
varying vec3 vStrokeNormal; // smoothed to the scale of a stroke, object space
#if TECHNIQUE == TECHNIQUE_STIPPLE
  varying float vViewUnitsPerPixel;
#else
  varying float vUnitsPerPixel; // object units per pixel
  varying vec3 vToViewer; // object space, of any length
  #if DIRECTION == DIRECTION_FORM || DIRECTION == DIRECTION_ACROSS_FORM
    #define STROKES_FOLLOW_FORM
    varying vec3 vFormSlope; // gradient of the function along whose level lines strokes run, object space, of any length
  #endif // DIRECTION
#endif // TECHNIQUE
