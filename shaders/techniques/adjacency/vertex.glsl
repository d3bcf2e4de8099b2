#include "perTriangle/vertex"

uniform float blendCosine; // cosine of the angle between normals from which on neighbours do not blend

// Algorithm 2's f at the vertices shared with a neighbour: N_c·N_t, with the crease angle moved to zero.
float sharedBlendFactor(const in vec3 centralNormal, const in vec3 neighbourNormal) {
  float cosine = dot(centralNormal, neighbourNormal);
  // At a crease angle of 0 nothing blends, and the divisor would be 0.
  return blendCosine < 1.0 ? max((cosine - blendCosine) / (1.0 - blendCosine), -1.0) : -1.0;
}
