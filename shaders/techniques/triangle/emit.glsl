// Algorithm 1: each triangle by itself.
#include "perTriangle/emit"
vStrokeUv = strokesC.xy;
#if LAYERS_BY_LIGHTS
  vCrossing = strokesC.z;
#endif // LAYERS_BY_LIGHTS
// Multiplied from the left by the inverse, that is by the inverse transpose, as normals need.
vFaceNormal = safeNormalize(normalC * viewToObject);
