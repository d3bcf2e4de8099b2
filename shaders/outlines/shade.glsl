// Illustrators draw the side away from the light with a heavier outline.
#include "lightLuminance"

uniform vec2 shadeWeights; // lit, shaded

// The direction that the light comes from at a point in view space: the mean of all lights by their luminance, not of unit length.
vec3 meanLight(const in vec3 viewPosition) {
  vec3 sum = vec3(0.0);
  IncidentLight light;
  #define VISIT_LIGHT(source, number) sum += lightLuminance(light.color) * light.direction;
  #include "eachLight"
  #define VISIT_LIGHT(source, number) sum += 0.5 * (lightLuminance(source.skyColor) - lightLuminance(source.groundColor)) * source.direction;
  #include "eachSky"
  return sum;
}

mat4 objectToView() {
  #ifdef USE_INSTANCING
    return modelViewMatrix * instancePlace;
  #else
    return modelViewMatrix;
  #endif // USE_INSTANCING
}

vec3 normalInView(const in vec3 normal) {
  #ifdef USE_INSTANCING
    return normalize(normalMatrix * (normal * inverse(mat3(instancePlace))));
  #else
    return normalize(normalMatrix * normal);
  #endif // USE_INSTANCING
}

// Up to the first of these, of (1 − N·L) / 2, an outline is as heavy as on the lit side, from the second on as in the shade.
#define LIT 0.15
#define SHADED 0.85

// The weight of an outline at a point by the light that falls on the surface there.
float shadeWeight(const in vec3 normal, const in vec3 light) {
  float brightness = dot(light, light);
  float shaded = brightness > 0.0 ? 0.5 - 0.5 * dot(normalInView(normal), light * inversesqrt(brightness)) : 0.5;
  return mix(shadeWeights.x, shadeWeights.y, smoothstep(LIT, SHADED, shaded));
}

void shade(inout Piece piece) {
  vec3 light = meanLight((objectToView() * vec4(0.5 * (piece.start.position + piece.end.position), 1.0)).xyz);
  piece.start.weight *= shadeWeight(piece.start.normal, light);
  piece.end.weight *= shadeWeight(piece.end.normal, light);
}
