// The direction from which a surface with normal n is lit, in its tangent plane: B of Algorithm 1.
//
// With one light it is the projected direction to the light. Several lights are averaged as axes, by a structure tensor, i.e. vectors of
// the doubled angle: lights from opposite sides reinforce each other, and a light along the normal has no effect. The sign is that of the
// weighted sum of the lights, which with one light is the sign of the paper.
//
// `crossing` ∈ [0, 1] is the disagreement of the lights: 1 minus the anisotropy of the tensor, 0 where they are collinear, 1 where no
// direction prevails.

#include "lightLuminance"

// A vector perpendicular to n, neither of unit length nor close to zero.
vec3 anyTangent(const in vec3 n) {
  return abs(n.x) > abs(n.z) ? vec3(-n.y, n.x, 0.0) : vec3(0.0, -n.z, n.y);
}

// Squared sine of the angle between light and normal below which a light gives no direction.
#define PARALLEL_SQUARED_SINE 1e-8

// In the shadow of a light strokes run across it. That direction has its pole elsewhere, so that no singularity of strokes shows in the
// shadow.
#ifdef REORIENTS_IN_SHADOW
  // toLight: unit, view space, as the result is.
  vec3 acrossLight(const in vec3 toLight) {
    vec3 up = viewMatrix[1].xyz;
    vec3 side = cross(toLight, abs(dot(toLight, up)) < 0.9 ? up : viewMatrix[0].xyz);
    return normalize(side);
  }

  void turnInShadow(const in bool isShadowed, inout IncidentLight light) {
    if (!isShadowed) return;
    light.direction = acrossLight(light.direction);
    light.color = vec3(0.0);
  }

  #define TURN_IN_SHADOW(number, light) turnInShadow(isLightShadowed[number], light)
#else
  #define TURN_IN_SHADOW(number, light)
#endif // REORIENTS_IN_SHADOW

#if LIGHTS_WITH_DIRECTION == 1

// Algorithm 1 for one light, as in the paper. n: unit normal, object space. viewPosition: the point, view space, from which the direction
// to a positional light is taken. viewToObject: linear part of the inverse of the model-view matrix.
vec3 lightBitangent(
  const in vec3 n, const in vec3 viewPosition, const in mat3 viewToObject, out float crossing
) {
  crossing = 0.0;
  IncidentLight light;
  #define VISIT_LIGHT(source, number) TURN_IN_SHADOW(number, light);
  #include "eachLight"
  vec3 l = viewToObject * light.direction;
  vec3 projected = l - n * dot(l, n);
  float squaredLength = dot(projected, projected);
  // L ∥ N: the lit pole is white and the unlit one black, so any tangent will do; for NaN too.
  vec3 chosen = squaredLength > PARALLEL_SQUARED_SINE * dot(l, l) ? projected : anyTangent(n);
  return chosen * inversesqrt(dot(chosen, chosen));
}

#else

struct LightOrientation {
  vec3 n;
  vec3 e1, e2; // orthonormal basis of the tangent plane
  vec2 tensor; // Σ w (lx² − ly², 2 lx ly)
  vec2 sum; // Σ w l
  float extent; // Σ w |l|²
  float weight; // Σ w
};

// Weight of a light where it does not reach, so that strokes keep a direction beyond a cone or a terminator.
#define UNLIT_WEIGHT 1e-4
// Cosine down to which a light counts beyond its terminator, so that strokes keep their direction there.
#define BEHIND_TERMINATOR 0.05

void addLight(inout LightOrientation o, const in vec3 toLight, const in vec3 arriving, const in vec3 emitted) {
  vec3 direction = normalize(toLight);
  vec2 l = vec2(dot(direction, o.e1), dot(direction, o.e2));
  float facing = max(dot(direction, o.n) + BEHIND_TERMINATOR, 0.0);
  float w = lightLuminance(arriving) * facing + UNLIT_WEIGHT * lightLuminance(emitted);
  o.tensor += w * vec2(l.x * l.x - l.y * l.y, 2.0 * l.x * l.y);
  o.sum += w * l;
  o.extent += w * dot(l, l);
  o.weight += w;
}

// The same for several lights, or none.
vec3 lightBitangent(
  const in vec3 n, const in vec3 viewPosition, const in mat3 viewToObject, out float crossing
) {
  LightOrientation o;
  o.n = n;
  o.e1 = normalize(anyTangent(n));
  o.e2 = cross(n, o.e1);
  o.tensor = vec2(0.0);
  o.sum = vec2(0.0);
  o.extent = 0.0;
  o.weight = 0.0;

  IncidentLight light;
  #define VISIT_LIGHT(source, number) TURN_IN_SHADOW(number, light); addLight(o, viewToObject * light.direction, light.color, source.color);
  #include "eachLight"
  #if LIGHTS_WITH_DIRECTION == 0
    // A hemisphere light gives a direction only if there is no other light.
    #define VISIT_LIGHT(source, number) addLight(o, viewToObject * source.direction, source.skyColor, source.skyColor);
    #include "eachSky"
  #endif // LIGHTS_WITH_DIRECTION

  float amplitude = length(o.tensor);
  // Lights along the normal give no direction, so they do not disagree.
  crossing = o.extent > PARALLEL_SQUARED_SINE * o.weight ? max(1.0 - amplitude / o.extent, 0.0) : 0.0;
  if (!(amplitude > PARALLEL_SQUARED_SINE * o.weight)) return o.e1;

  // Half of the doubled angle without trigonometry, from the side without cancellation.
  vec2 b = o.tensor.x >= 0.0
    ? vec2(amplitude + o.tensor.x, o.tensor.y)
    : vec2(o.tensor.y, amplitude - o.tensor.x);
  b = normalize(dot(b, o.sum) < 0.0 ? -b : b);
  return b.x * o.e1 + b.y * o.e2;
}

#endif // LIGHTS_WITH_DIRECTION
