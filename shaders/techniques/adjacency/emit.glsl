// Algorithm 2: besides the triangle's own coordinates, those in its neighbours' frames and the blend factors.
#include "perTriangle/emit"
vec3 normalAlpha = normalOf(triangleAlpha(drawn));
vec3 normalBeta = normalOf(triangleBeta(drawn));
vec3 normalGamma = normalOf(triangleGamma(drawn));
vec3 strokesAlpha = strokeCoordinates(
  anchorPosition, triangleAlpha(anchor), triangleAlpha(drawn), normalAlpha, turns.alpha, objectToView, viewToObject
);
vec3 strokesBeta = strokeCoordinates(
  anchorPosition, triangleBeta(anchor), triangleBeta(drawn), normalBeta, turns.beta, objectToView, viewToObject
);
vec3 strokesGamma = strokeCoordinates(
  anchorPosition, triangleGamma(anchor), triangleGamma(drawn), normalGamma, turns.gamma, objectToView, viewToObject
);
vStrokeUvCentralAlpha = vec4(strokesC.xy, strokesAlpha.xy);
vStrokeUvBetaGamma = vec4(strokesBeta.xy, strokesGamma.xy);
#if LAYERS_BY_LIGHTS
  vCrossing = vec4(strokesC.z, strokesAlpha.z, strokesBeta.z, strokesGamma.z);
#endif // LAYERS_BY_LIGHTS
// −1 at the vertex that does not belong to the neighbour (Algorithm 2): corner 2 for α, 0 for β, 1 for γ.
vec3 blendFactors = vec3(
  drawn.corner == 2 ? -1.0 : sharedBlendFactor(normalC, normalAlpha),
  drawn.corner == 0 ? -1.0 : sharedBlendFactor(normalC, normalBeta),
  drawn.corner == 1 ? -1.0 : sharedBlendFactor(normalC, normalGamma)
);
#if TONE_NORMAL == TONE_NORMAL_SMOOTH
  vBlendFactors = blendFactors;
#else
  // Multiplied from the left by the inverse, that is by the inverse transpose, as normals need.
  vFaceNormalCentral = safeNormalize(normalC * viewToObject);
  vFaceNormalAlpha = vec4(safeNormalize(normalAlpha * viewToObject), blendFactors.x);
  vFaceNormalBeta = vec4(safeNormalize(normalBeta * viewToObject), blendFactors.y);
  vFaceNormalGamma = vec4(safeNormalize(normalGamma * viewToObject), blendFactors.z);
#endif // TONE_NORMAL
