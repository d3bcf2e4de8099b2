// What hatching needs to know at this fragment: the frame of its strokes is found here, so that it turns continuously.
#include "lightOrientation"
#include "perFragment/viewToAnchor"

struct HatchingParameters {
  vec3 point; // object space
  vec3 uAxis, vAxis; // the strokes' u and v in the surface, object space
  #if MEDIUM == MEDIUM_STIPPLE
    vec3 normal; // object space
  #else
    vec3 lean; // of u, v and the normal towards the viewer: proportional to their cosines
  #endif // MEDIUM
  float crossing; // how far the lights disagree
};

#ifdef STROKES_FOLLOW_FORM
  #include "technique/readForm"
#elif STROKE_FIELD == STROKE_FIELD_SHEET && MEDIUM != MEDIUM_STIPPLE
  #include "technique/readSheet"
#else
  #include "technique/readLight"
#endif // STROKES_FOLLOW_FORM

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  vec3 n = safeNormalize(vStrokeNormal);
  readStrokeAxes(n, h);
  h.point = vRestPosition;
  #if MEDIUM == MEDIUM_STIPPLE
    h.normal = n;
  #else
    h.lean = vToViewer * mat3(h.uAxis, h.vAxis, n);
  #endif // MEDIUM
  return h;
}
