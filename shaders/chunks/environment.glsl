// The light of the scene's environment map. It is a define, since some devices run both sides of a branch.
#ifdef ENVIRONMENT
uniform float environmentIntensity;
uniform mat3 environmentRotation; // from world space to the map
#include "environment/layout"

// n: view space.
vec3 environmentIrradiance(const in vec3 n) {
  // A vector times a matrix is the transpose times the vector, and the transpose of a rotation is its inverse.
  vec3 inWorld = n * mat3(viewMatrix);
  return PI * environmentIntensity * blurredEnvironment(environmentRotation * inWorld);
}
#endif // ENVIRONMENT
