#include "perFragment/emit"
vRestPosition = anchorPosition;
vStrokeNormal = strokeNormal;
#if TECHNIQUE == TECHNIQUE_STIPPLE
  vViewUnitsPerPixel = unitsPerPixel(mat3(1.0), mvPosition);
#else
  vUnitsPerPixel = unitsPerPixel(viewToAnchor, mvPosition);
  vToViewer = viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition);
#endif // TECHNIQUE
#ifdef STROKES_FOLLOW_FORM
  vFormSlope = formSlope.xyz;
  #if STROKE_ANCHOR != STROKE_ANCHOR_REST
    // A gradient transforms as a normal does.
    vFormSlope = vFormSlope * deformedToRest;
  #endif // STROKE_ANCHOR
#endif // STROKES_FOLLOW_FORM
