#include "perFragment/emit"
vRestPosition = anchorPosition;
vStrokeNormal = strokeNormal;
#if MEDIUM == MEDIUM_STIPPLE
  vViewUnitsPerPixel = unitsPerPixel(mat3(1.0), mvPosition);
#else
  vUnitsPerPixel = unitsPerPixel(viewToAnchor, mvPosition);
  vToViewer = viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition);
#endif // MEDIUM
