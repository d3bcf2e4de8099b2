// The light of the scene's environment, an image all around.
uniform float environmentIntensity; // 0 where there is none
uniform mat3 environmentRotation; // from world space into the image
#include "environment/layout"

// n: view space.
vec3 environmentIrradiance(const in vec3 n) {
  // The same in every fragment, so nothing is fetched in vain, and an environment that comes or goes builds no program.
  if (environmentIntensity == 0.0) return vec3(0.0);
  // From the left is the transpose, the inverse of a rotation.
  vec3 inWorld = n * mat3(viewMatrix);
  return PI * environmentIntensity * blurredEnvironment(environmentRotation * inWorld);
}
