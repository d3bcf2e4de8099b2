#include "perFragment/emit"
vRestPosition = anchorPosition;
vStrokeNormal = strokeNormal;
vUnitsPerPixel = unitsPerPixel(viewToAnchor, mvPosition);
vToViewer = viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition);
