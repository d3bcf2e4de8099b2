// What hatching needs to know at this fragment.
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "triangleGeometry"
  #include "lightOrientation"

  uniform vec2 strokeDirection; // cosine and sine of the strokes' rotation
#endif // TECHNIQUE

struct HatchingParameters {
  #if TECHNIQUE == TECHNIQUE_ANCHORED
    vec3 uAxis, vAxis; // the strokes' u and v in the surface, object space
  #else
    vec2 uv[TRIANGLE_COUNT]; // in the frames of c, α, β, γ
  #endif // TECHNIQUE
  vec4 weights; // f of c, α, β, γ, clamped
};

// A zero-area triangle has no normal; one towards the viewer is as good as any for the pixel it may still cover.
vec3 safeNormalize(const in vec3 v) {
  float squaredLength = dot(v, v);
  return squaredLength > 0.0 ? v * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
}

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  #if TECHNIQUE == TECHNIQUE_ADJACENCY
    h.uv[0] = vStrokeUvCentralAlpha.xy;
    h.uv[1] = vStrokeUvCentralAlpha.zw;
    h.uv[2] = vStrokeUvBetaGamma.xy;
    h.uv[3] = vStrokeUvBetaGamma.zw;
    // −1 at the opposite vertex gives the slope of figure 7, it is no contribution to subtract. Clamping the vertices
    // instead would stretch the support over the whole triangle.
    h.weights = vec4(1.0, max(vBlendFactors, 0.0));
  #elif TECHNIQUE == TECHNIQUE_ANCHORED
    vec3 n = safeNormalize(vStrokeNormal);
    vec3 bitangent = lightBitangent(n, -vViewPosition, vViewToObject);
    vec3 tangent = cross(bitangent, n);
    h.uAxis = strokeDirection.x * tangent - strokeDirection.y * bitangent;
    h.vAxis = strokeDirection.y * tangent + strokeDirection.x * bitangent;
    h.weights = vec4(1.0, 0.0, 0.0, 0.0);
  #else
    h.uv[0] = vStrokeUv;
    h.weights = vec4(1.0, 0.0, 0.0, 0.0);
  #endif // TECHNIQUE
  return h;
}
