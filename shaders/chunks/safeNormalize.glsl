// A zero-area triangle has no normal; one towards the viewer is as good as any for the pixel it may still cover.
vec3 safeNormalize(const in vec3 v) {
  float squaredLength = dot(v, v);
  return squaredLength > 0.0 ? v * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
}
