#include "lightLuminance"

// The direction from which light comes at a point in view space: the mean of all lights, weighted by luminance; not of unit length.
vec3 meanLight(const in vec3 viewPosition) {
  vec3 sum = vec3(0.0);
  IncidentLight light;
  #define VISIT_LIGHT(source, number) sum += lightLuminance(light.color) * light.direction;
  #include "eachLight"
  #define VISIT_LIGHT(source, number) sum += 0.5 * (lightLuminance(source.skyColor) - lightLuminance(source.groundColor)) * source.direction;
  #include "eachSky"
  return sum;
}
