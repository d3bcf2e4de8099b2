// The unit vector, or the direction to the viewer for the null vector that a zero-area triangle has for a normal.
vec3 safeNormalize(const in vec3 v) {
  // Too small to turn any other vector, and large enough for its square not to underflow.
  vec3 any = vec3(v.xy, v.z + 2e-19);
  return any * inversesqrt(dot(any, any));
}
