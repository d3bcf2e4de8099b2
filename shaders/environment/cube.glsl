// three.js 0.187 blurs an environment into a cube, level by level. The last level is the irradiance over π.
uniform samplerCube environment;

vec3 blurredEnvironment(const in vec3 direction) {
  return textureLod(environment, direction, 99.0).rgb;
}
