// The light of the scene's environment, an image all around, where there is one. It is a define,
// because some devices compute both sides of a branch.
#ifdef ENVIRONMENT
uniform float environmentIntensity;
uniform mat3 environmentRotation; // from world space into the image
#include "environment/layout"

// n: view space.
vec3 environmentIrradiance(const in vec3 n) {
  // A vector times a matrix is multiplied by the transpose, which is the inverse of a rotation.
  vec3 inWorld = n * mat3(viewMatrix);
  return PI * environmentIntensity * blurredEnvironment(environmentRotation * inWorld);
}
#endif // ENVIRONMENT
