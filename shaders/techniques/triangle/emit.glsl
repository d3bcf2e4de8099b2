// Algorithm 1: every triangle for itself.
#include "perTriangle/emit"
vStrokeUv = strokesC.xy;
#if LAYERS_BY_LIGHTS
  vCrossing = strokesC.z;
#endif // LAYERS_BY_LIGHTS
// A normal times the inverse from the left is the inverse transpose times the normal: right for every matrix.
vFaceNormal = safeNormalize(normalC * viewToObject);
