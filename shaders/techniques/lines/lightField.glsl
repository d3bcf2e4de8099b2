// One light for the whole object, so that lines run on: a single light itself, or of several lights the principal axis of Σ w L Lᵀ, on
// which they agree most and in which opposite lights do not cancel.
#include "lightLuminance"

// The weight of a light.
float fieldWeight(const in vec3 color) {
  return lightLuminance(color) + LEAST_WEIGHT;
}

// Σ w L Lᵀ and Σ w L. toLight: of any length, field space.
void addFieldLight(inout mat3 tensor, inout vec3 sum, const in vec3 toLight, const in vec3 color) {
  vec3 l = toLight / max(length(toLight), 1e-20);
  float w = fieldWeight(color);
  tensor += w * outerProduct(l, l);
  sum += w * l;
}

// The contribution of a lamp to Σ w c / |P|, c = L·axis: the curvature of the sum of the lights' own fields, −|P − P_L| for a lamp, at the
// origin.
float fieldBend(const in vec3 axis, const in vec3 toLamp, const in vec3 color) {
  return fieldWeight(color) * dot(toLamp, axis) / max(dot(toLamp, toLamp), 1e-20);
}

vec3 fieldAxisOf(const in mat3 tensor, const in vec3 sum) {
  #if LIGHTS_WITH_DIRECTION == 1
    return sum / max(length(sum), 1e-20);
  #else
    // Power iteration: four squarings equal sixteen steps.
    mat3 power = tensor;
    for (int i = 0; i < 4; i++) power = power * power / max(power[0][0] + power[1][1] + power[2][2], 1e-20);
    vec3 axis = power * FIRST_AXIS;
    axis /= max(length(axis), 1e-20);
    return dot(axis, sum) < 0.0 ? -axis : axis;
  #endif // LIGHTS_WITH_DIRECTION
}

// Lights that do not arrive are left out, where shadows are known.
#ifdef REORIENTS_IN_SHADOW
  #define ARRIVING(number, color) (isLightShadowed[number] ? vec3(0.0) : color)
#else
  #define ARRIVING(number, color) color
#endif // REORIENTS_IN_SHADOW

// The light of the field: unit direction, and reciprocal of the distance, field space. viewToField: linear part. place: any, view space.
// fromOrigin: the same place in field space.
vec4 fieldLight(const in mat3 viewToField, const in vec3 place, const in vec3 fromOrigin) {
  #if LIGHTS_WITH_DIRECTION == 0
    return vec4(0.0, 1.0, 0.0, 0.0);
  #else
    mat3 tensor = mat3(0.0);
    vec3 sum = vec3(0.0);
    #define VISIT_LIGHT(source, number) addFieldLight(tensor, sum, viewToField * source.direction, ARRIVING(number, source.color));
    #include "eachDistantLight"
    #define TO_LAMP(source) (viewToField * (source.position - place) + fromOrigin)
    #define VISIT_LIGHT(source, number) addFieldLight(tensor, sum, TO_LAMP(source), ARRIVING(number, source.color));
    #include "eachPositionalLight"
    vec3 axis = fieldAxisOf(tensor, sum);
    float bend = 0.0;
    #define VISIT_LIGHT(source, number) bend += fieldBend(axis, TO_LAMP(source), ARRIVING(number, source.color));
    #include "eachPositionalLight"
    // A single lamp at this place has the same curvature. Directional lights have no curvature, but their slope counts.
    return vec4(axis, bend / max(length(tensor * axis), 1e-20));
  #endif // LIGHTS_WITH_DIRECTION
}
