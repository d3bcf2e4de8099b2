// The parameters of hatching at a fragment, with the frame of strokes, which is found per fragment so that it turns continuously.
#include "lightOrientation"
#include "perFragment/viewToAnchor"

struct HatchingParameters {
  vec3 point; // object space
  vec3 uAxis, vAxis; // the strokes' u and v in the surface, object space
  #if TECHNIQUE == TECHNIQUE_STIPPLE
    vec3 normal; // object space
  #else
    vec3 lean; // components of the direction to the viewer along u, v and the normal, of any length
  #endif // TECHNIQUE
  float crossing; // disagreement of the lights
};

#ifdef STROKES_FOLLOW_FORM
  #include "technique/readForm"
#elif DIRECTION == DIRECTION_SHEET && TECHNIQUE != TECHNIQUE_STIPPLE
  #include "technique/readSheet"
#else
  #include "technique/readLight"
#endif // STROKES_FOLLOW_FORM

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  vec3 n = safeNormalize(vStrokeNormal);
  readStrokeAxes(n, h);
  h.point = vRestPosition;
  #if TECHNIQUE == TECHNIQUE_STIPPLE
    h.normal = n;
  #else
    h.lean = vToViewer * mat3(h.uAxis, h.vAxis, n);
  #endif // TECHNIQUE
  return h;
}
