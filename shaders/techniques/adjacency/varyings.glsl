#include "perTriangle/varyings"

varying vec4 vStrokeUvCentralAlpha; // (u, v) in the frame of c, then of α
varying vec4 vStrokeUvBetaGamma; // (u, v) in the frame of β, then of γ
// f of α, β, γ may be negative: it is clamped per fragment, after interpolation. Normals are equal at the three corners, so they need no
// `flat`. Each shares a row with a factor: WebGL 2 guarantees 15 rows, which shadows and maps need too.
#if TONE_NORMAL == TONE_NORMAL_SMOOTH
  varying vec3 vBlendFactors;
#else
  varying vec3 vFaceNormalCentral; // unit, view space, as are the others
  varying vec4 vFaceNormalAlpha; // with the blend factor
  varying vec4 vFaceNormalBeta;
  varying vec4 vFaceNormalGamma;
#endif // TONE_NORMAL
#if LAYERS_BY_LIGHTS
  varying vec4 vCrossing; // disagreement of the lights in the frames of c, α, β, γ
#endif // LAYERS_BY_LIGHTS
