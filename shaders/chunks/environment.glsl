// The light of the scene's environment, an image all around, where there is one. A define: some devices compute either side of a branch.
#ifdef ENVIRONMENT
uniform float environmentIntensity;
uniform mat3 environmentRotation; // from world space into the image
#include "environment/layout"

// n: view space.
vec3 environmentIrradiance(const in vec3 n) {
  // From the left is the transpose, the inverse of a rotation.
  vec3 inWorld = n * mat3(viewMatrix);
  return PI * environmentIntensity * blurredEnvironment(environmentRotation * inWorld);
}
#endif // ENVIRONMENT
