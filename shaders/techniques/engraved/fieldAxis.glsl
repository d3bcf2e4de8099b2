uniform float crossAngle; // radians between a family and what crosses it

// Any unit vector across another, the same for neighbours of it.
vec3 across(const in vec3 axis) {
  return normalize(abs(axis.y) < 0.8 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(0.0, 0.0, 1.0)));
}

// What the first family is cut by: planes across this axis.
vec3 fieldAxis(const in vec3 toLight) {
  #if LINE_FIELD == LINE_FIELD_LIGHT
    return toLight;
  #elif LINE_FIELD == LINE_FIELD_TOWARDS
    return across(toLight);
  #elif LINE_FIELD == LINE_FIELD_X
    return vec3(1.0, 0.0, 0.0);
  #elif LINE_FIELD == LINE_FIELD_Y
    return vec3(0.0, 1.0, 0.0);
  #else
    return vec3(0.0, 0.0, 1.0);
  #endif // LINE_FIELD
}
