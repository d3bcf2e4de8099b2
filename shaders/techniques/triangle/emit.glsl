// Algorithm 1: every triangle for itself.
#include "perTriangle/emit"
vStrokeUv = strokesC.xy;
#if STROKE_LAYERS == 2
  vCrossing = strokesC.z;
#endif // STROKE_LAYERS
// A normal times the inverse from the left is the inverse transpose times the normal: right for every matrix.
vFaceNormal = normalC * viewToObject;
