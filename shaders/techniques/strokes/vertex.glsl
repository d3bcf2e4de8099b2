#include "perFragment/vertex"
#ifdef STROKES_FOLLOW_FORM
  attribute vec4 formSlope; // xyz: gradient of the baked function, at one scale for the whole geometry (src/mesh/bake/attributeLayouts.ts)
#endif // STROKES_FOLLOW_FORM
