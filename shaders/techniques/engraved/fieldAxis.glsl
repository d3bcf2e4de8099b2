// The function that lines are level sets of: the distance along an axis, or from a lamp.
struct Field {
  vec3 axis; // its gradient at the origin, unit
  float bend; // one over the distance of the lamp it counts from, 0 for planes across the axis
};

// Any unit vector across another, the same for neighbours of it.
vec3 across(const in vec3 axis) {
  return normalize(abs(axis.y) < 0.8 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(0.0, 0.0, 1.0)));
}

uniform vec2 strokeDirection; // cosine and sine of the angle by which strokes are turned from the tangent to the light

// light: towards it, unit, and one over its distance, field space.
Field firstField(const in vec4 light) {
  #if LINE_FIELD == LINE_FIELD_LIGHT
    return Field(strokeDirection.x * light.xyz + strokeDirection.y * across(light.xyz), strokeDirection.x * light.w);
  #elif LINE_FIELD == LINE_FIELD_TOWARDS
    return Field(strokeDirection.x * across(light.xyz) - strokeDirection.y * light.xyz, -strokeDirection.y * light.w);
  #elif LINE_FIELD == LINE_FIELD_X
    return Field(vec3(1.0, 0.0, 0.0), 0.0);
  #elif LINE_FIELD == LINE_FIELD_Y
    return Field(vec3(0.0, 1.0, 0.0), 0.0);
  #else
    return Field(vec3(0.0, 0.0, 1.0), 0.0);
  #endif // LINE_FIELD
}

// The value at a point, 0 at the origin: |P_L| − |P − P_L| in a form that holds at any distance, and without an end is P·axis.
// gradient: unit.
float fieldAt(const in Field field, const in vec3 point, out vec3 gradient) {
  vec3 toLamp = field.axis - field.bend * point; // over the distance of the lamp
  float far = max(length(toLamp), 1e-6);
  gradient = toLamp / far;
  return dot(point, field.axis + toLamp) / (1.0 + far);
}
