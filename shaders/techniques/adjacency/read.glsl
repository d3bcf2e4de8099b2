// The parameters of hatching at a fragment.
struct HatchingParameters {
  vec2 uv[4]; // in the frames of c, α, β, γ
  vec4 weights; // f of c, α, β, γ, clamped
};

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  h.uv[0] = vStrokeUvCentralAlpha.xy;
  h.uv[1] = vStrokeUvCentralAlpha.zw;
  h.uv[2] = vStrokeUvBetaGamma.xy;
  h.uv[3] = vStrokeUvBetaGamma.zw;
  // The −1 at the opposite vertex sets the slope of figure 7 and is not subtracted. Clamping at the vertices instead would stretch the
  // support over the whole triangle.
  #if TONE_NORMAL == TONE_NORMAL_SMOOTH
    vec3 blendFactors = vBlendFactors;
  #else
    vec3 blendFactors = vec3(vFaceNormalAlpha.w, vFaceNormalBeta.w, vFaceNormalGamma.w);
  #endif // TONE_NORMAL
  h.weights = vec4(1.0, max(blendFactors, 0.0));
  return h;
}

// Algorithm 3, Σ Color·f / Σ f: one value from those of c, α, β, γ.
float blend(const in HatchingParameters h, const in vec4 values) {
  // f of c is 1, so the sum of the weights is at least 1.
  return dot(values, h.weights) / dot(h.weights, vec4(1.0));
}
