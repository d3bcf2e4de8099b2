// What hatching needs to know at this fragment.
struct HatchingParameters {
  vec2 uv;
};

HatchingParameters readHatchingParameters() {
  return HatchingParameters(vStrokeUv);
}
