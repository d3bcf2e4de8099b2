#include "perTriangle/varyings"

varying vec4 vStrokeUvCentralAlpha; // (u, v) in the frame of c, then of α
varying vec4 vStrokeUvBetaGamma; // (u, v) in the frame of β, then of γ
varying vec3 vBlendFactors; // f of α, β, γ; may be negative: clamped per fragment, after interpolation
varying mat4x3 vFaceNormals; // of c, α, β, γ, view space; equal at the three corners, so they need no `flat`
#if STROKE_LAYERS == 2
  varying vec4 vCrossing; // how far the lights disagree in the frames of c, α, β, γ
#endif // STROKE_LAYERS
