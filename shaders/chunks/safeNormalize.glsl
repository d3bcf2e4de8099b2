// A zero-area triangle has no normal; one towards the viewer is as good as any for the pixel it may still cover.
vec3 safeNormalize(const in vec3 v) {
  // So little turns no other vector, and its square is still a number.
  vec3 any = vec3(v.xy, v.z + 2e-19);
  return any * inversesqrt(dot(any, any));
}
