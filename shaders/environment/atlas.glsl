// Before 0.187 three.js blurs an environment into an atlas of cube maps. At a roughness of 1 it holds the irradiance over π.
uniform sampler2D environment;
uniform vec3 environmentAtlas; // width and height of a texel, and index of the finest level

#define ENVMAP_TYPE_CUBE_UV
#define CUBEUV_TEXEL_WIDTH environmentAtlas.x
#define CUBEUV_TEXEL_HEIGHT environmentAtlas.y
#define CUBEUV_MAX_MIP environmentAtlas.z
#include <cube_uv_reflection_fragment>

vec3 blurredEnvironment(const in vec3 direction) {
  return textureCubeUV(environment, direction, 1.0).rgb;
}
