// The light as one direction for the whole object, so that lines run on: with one light the direction to it, with several the
// axis on which they agree most, the principal axis of Σ w L Lᵀ, which lights from opposite sides do not cancel. A lamp counts
// by where it stands as seen from the object's centre.
#include "lightLuminance"

uniform vec3 fieldCentre; // of the bounding sphere, object space

// Σ w L Lᵀ and Σ w L.
void addFieldLight(inout mat3 tensor, inout vec3 sum, const in vec3 toLight, const in vec3 color) {
  vec3 l = toLight / max(length(toLight), 1e-20);
  // A lamp that is out still stands somewhere.
  float w = lightLuminance(color) + 1e-6;
  tensor += w * outerProduct(l, l);
  sum += w * l;
}

// Unit, object space. viewToObject: linear part. centre: of the object, view space.
vec3 fieldLight(const in mat3 viewToObject, const in vec3 centre) {
  mat3 tensor = mat3(0.0);
  vec3 sum = vec3(0.0);
  #if NUM_DIR_LIGHTS > 0
    for (int i = 0; i < NUM_DIR_LIGHTS; i++) {
      addFieldLight(tensor, sum, viewToObject * directionalLights[i].direction, directionalLights[i].color);
    }
  #endif // NUM_DIR_LIGHTS
  #if NUM_SUN_LIGHTS > 0
    for (int i = 0; i < NUM_SUN_LIGHTS; i++) {
      addFieldLight(tensor, sum, viewToObject * sunLights[i].direction, sunLights[i].color);
    }
  #endif // NUM_SUN_LIGHTS
  #if NUM_POINT_LIGHTS > 0
    for (int i = 0; i < NUM_POINT_LIGHTS; i++) {
      addFieldLight(tensor, sum, viewToObject * (pointLights[i].position - centre), pointLights[i].color);
    }
  #endif // NUM_POINT_LIGHTS
  #if NUM_SPOT_LIGHTS > 0
    for (int i = 0; i < NUM_SPOT_LIGHTS; i++) {
      addFieldLight(tensor, sum, viewToObject * (spotLights[i].position - centre), spotLights[i].color);
    }
  #endif // NUM_SPOT_LIGHTS
  #if LIGHTS_WITH_DIRECTION == 0
    return vec3(0.0, 1.0, 0.0);
  #elif LIGHTS_WITH_DIRECTION == 1
    return sum / max(length(sum), 1e-20);
  #else
    // Power iteration: four squarings are sixteen steps. It starts from what every axis has a part of.
    for (int i = 0; i < 4; i++) tensor = tensor * tensor / max(tensor[0][0] + tensor[1][1] + tensor[2][2], 1e-20);
    vec3 axis = tensor * vec3(0.51, 0.64, 0.57);
    axis /= max(length(axis), 1e-20);
    return dot(axis, sum) < 0.0 ? -axis : axis;
  #endif // LIGHTS_WITH_DIRECTION
}
