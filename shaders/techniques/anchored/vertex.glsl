#include "perFragment/vertex"
#ifdef STROKES_FOLLOW_FORM
  attribute vec4 formSlope; // xyz: of the function that was baked, at one scale all over the geometry (src/mesh/bake/attributeLayouts.ts)
#endif // STROKES_FOLLOW_FORM
