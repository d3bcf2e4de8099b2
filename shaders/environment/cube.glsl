// three.js 0.187 blurs an environment into the levels of a cube map. The last level is the irradiance over π.
uniform samplerCube environment;

vec3 blurredEnvironment(const in vec3 direction) {
  return textureLod(environment, direction, 99.0).rgb;
}
