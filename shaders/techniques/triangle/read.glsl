// The parameters of hatching at a fragment.
struct HatchingParameters {
  vec2 uv;
};

HatchingParameters readHatchingParameters() {
  return HatchingParameters(vStrokeUv);
}
