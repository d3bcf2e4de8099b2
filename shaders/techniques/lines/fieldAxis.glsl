// The function whose level sets are lines: the distance along an axis, or from a lamp.
struct Field {
  vec3 axis; // gradient at the origin, unit
  float bend; // reciprocal of the distance of the lamp, 0 for planes across the axis
};

// A unit vector across another, continuous in it.
vec3 across(const in vec3 axis) {
  return normalize(abs(axis.y) < UPRIGHT ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(0.0, 0.0, 1.0)));
}

uniform vec2 strokeDirection; // cosine and sine of the angle by which lines are turned, counterclockwise

#ifdef RUNS_AWAY
  // The axis across the light and along the ground, so that lines on the ground run away from the light. The coordinate axis nearest to the
  // normal stands for that of the ground, so that no line breaks.
  vec3 acrossGround(const in vec3 light) {
    vec3 size = abs(vFieldNormal);
    vec3 up = size.y >= size.x && size.y >= size.z ? vec3(0.0, 1.0, 0.0) : size.z >= size.x ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 side = cross(light, up);
    float sine = length(side);
    return sine > LEAST_SINE ? side / sine : across(light);
  }
#endif // RUNS_AWAY

// light: unit direction towards it, and reciprocal of its distance, field space.
Field firstField(const in vec4 light) {
  #ifdef RUNS_AWAY
    return Field(acrossGround(light.xyz), 0.0);
  #elif DIRECTION == DIRECTION_LIGHT
    return Field(strokeDirection.x * light.xyz + strokeDirection.y * across(light.xyz), strokeDirection.x * light.w);
  #elif DIRECTION == DIRECTION_TOWARDS_LIGHT
    return Field(strokeDirection.x * across(light.xyz) - strokeDirection.y * light.xyz, -strokeDirection.y * light.w);
  #elif DIRECTION == DIRECTION_X
    return Field(vec3(1.0, 0.0, 0.0), 0.0);
  #elif DIRECTION == DIRECTION_Y
    return Field(vec3(0.0, 1.0, 0.0), 0.0);
  #elif DIRECTION == DIRECTION_Z
    return Field(vec3(0.0, 0.0, 1.0), 0.0);
  #else
    return Field(SLANT, 0.0);
  #endif // RUNS_AWAY
}

// The value at a point, 0 at the origin: |P_L| − |P − P_L| in a form that holds at any distance, P·axis in the limit. gradient: unit.
float fieldAt(const in Field field, const in vec3 point, out vec3 gradient) {
  #if !defined(TURNS_WITH_LIGHT) || POSITIONAL_LIGHTS == 0
    // A plane field.
    gradient = field.axis;
    return dot(point, field.axis);
  #else
    vec3 toLamp = field.axis - field.bend * point; // in units of the distance of the lamp
    float far = max(length(toLamp), 1e-6);
    gradient = toLamp / far;
    return dot(point, field.axis + toLamp) / (1.0 + far);
  #endif // TURNS_WITH_LIGHT
}
