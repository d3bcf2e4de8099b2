#include "perFragment/emit"
vToViewer = viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition);
