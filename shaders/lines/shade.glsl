// Illustrators draw the side away from the light with a heavier line.
#include "lightLuminance"

uniform vec2 shadeWeights; // lit, shaded

// The direction the light comes from at a point in view space, all lights by their luminance; not of unit length.
vec3 meanLight(const in vec3 position) {
  vec3 sum = vec3(0.0);
  IncidentLight light;
  #if NUM_DIR_LIGHTS > 0
    for (int i = 0; i < NUM_DIR_LIGHTS; i++) {
      getDirectionalLightInfo(directionalLights[i], light);
      sum += lightLuminance(light.color) * light.direction;
    }
  #endif // NUM_DIR_LIGHTS
  #if NUM_SUN_LIGHTS > 0
    for (int i = 0; i < NUM_SUN_LIGHTS; i++) {
      getSunLightInfo(sunLights[i], light);
      sum += lightLuminance(light.color) * light.direction;
    }
  #endif // NUM_SUN_LIGHTS
  #if NUM_POINT_LIGHTS > 0
    for (int i = 0; i < NUM_POINT_LIGHTS; i++) {
      getPointLightInfo(pointLights[i], position, light);
      sum += lightLuminance(light.color) * light.direction;
    }
  #endif // NUM_POINT_LIGHTS
  #if NUM_SPOT_LIGHTS > 0
    for (int i = 0; i < NUM_SPOT_LIGHTS; i++) {
      getSpotLightInfo(spotLights[i], position, light);
      sum += lightLuminance(light.color) * light.direction;
    }
  #endif // NUM_SPOT_LIGHTS
  #if NUM_HEMI_LIGHTS > 0
    for (int i = 0; i < NUM_HEMI_LIGHTS; i++) {
      float sky = lightLuminance(hemisphereLights[i].skyColor) - lightLuminance(hemisphereLights[i].groundColor);
      sum += 0.5 * sky * hemisphereLights[i].direction;
    }
  #endif // NUM_HEMI_LIGHTS
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

// What the line weighs at a point by the light that falls on the surface there.
float shadeWeight(const in vec3 normal, const in vec3 light) {
  float brightness = dot(light, light);
  float shaded = brightness > 0.0 ? 0.5 - 0.5 * dot(normalInView(normal), light * inversesqrt(brightness)) : 0.5;
  return mix(shadeWeights.x, shadeWeights.y, smoothstep(0.15, 0.85, shaded));
}

void shade(inout Piece piece) {
  vec3 light = meanLight((objectToView() * vec4(0.5 * (piece.start.position + piece.end.position), 1.0)).xyz);
  piece.start.weight *= shadeWeight(piece.start.normal, light);
  piece.end.weight *= shadeWeight(piece.end.normal, light);
}
