#include "perTriangle/varyings"

varying vec2 vStrokeUv;
varying vec3 vFaceNormal; // view space; equal at the three corners, so it needs no `flat`
#if LAYERS_BY_LIGHTS
  varying float vCrossing; // disagreement of the lights
#endif // LAYERS_BY_LIGHTS
