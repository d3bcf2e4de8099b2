// What hatching needs to know at this fragment.
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "triangleGeometry"
  #include "lightOrientation"

  uniform vec2 strokeDirection; // cosine and sine of the strokes' rotation
  uniform float anchorSpacing; // tiles between anchors
#endif // TECHNIQUE
#ifdef USE_UNITS_PER_PIXEL
  uniform float strokeScale; // tiles per object unit
#endif // USE_UNITS_PER_PIXEL

struct HatchingParameters {
  #if TECHNIQUE == TECHNIQUE_ANCHORED
    vec3 point; // object space
    vec3 uAxis, vAxis; // the strokes' u and v in the surface, object space
    vec3 lean; // of u, v and the normal towards the viewer: proportional to their cosines
  #else
    vec2 uv[TRIANGLE_COUNT]; // in the frames of c, α, β, γ
  #endif // TECHNIQUE
  vec4 weights; // f of c, α, β, γ, clamped
  #if STROKE_LAYERS == 2
    float crossing; // how far the lights disagree
  #endif // STROKE_LAYERS
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
    float crossing;
    vec3 bitangent = lightBitangent(n, -vViewPosition, vViewToObject, crossing);
    vec3 tangent = cross(bitangent, n);
    h.point = vRestPosition;
    h.uAxis = strokeDirection.x * tangent - strokeDirection.y * bitangent;
    h.vAxis = strokeDirection.y * tangent + strokeDirection.x * bitangent;
    h.lean = vToViewer * mat3(h.uAxis, h.vAxis, n);
    h.weights = vec4(1.0, 0.0, 0.0, 0.0);
  #else
    h.uv[0] = vStrokeUv;
    h.weights = vec4(1.0, 0.0, 0.0, 0.0);
  #endif // TECHNIQUE
  #if STROKE_LAYERS == 2
    #if TECHNIQUE == TECHNIQUE_ANCHORED
      h.crossing = crossing;
    #else
      h.crossing = dot(vCrossing, h.weights) / dot(h.weights, vec4(1.0));
    #endif // TECHNIQUE
  #endif // STROKE_LAYERS
  return h;
}

#if STROKE_LAYERS == 2
  // What shifts the second layer's pattern against the first's, in tiles or, for `anchored`, in anchors.
  #define LAYER_SHIFT vec3(17.37, 5.71, 11.13)

  // The same place in the second layer, whose strokes run along the other direction of the tensor: all turned by 90°.
  HatchingParameters secondLayer(const in HatchingParameters h) {
    HatchingParameters second = h;
    #if TECHNIQUE == TECHNIQUE_ANCHORED
      second.point = h.point + LAYER_SHIFT * anchorSpacing / strokeScale;
      second.uAxis = -h.vAxis;
      second.vAxis = h.uAxis;
      second.lean = vec3(-h.lean.y, h.lean.x, h.lean.z);
    #else
      for (int i = 0; i < TRIANGLE_COUNT; i++) {
        second.uv[i] = vec2(-h.uv[i].y, h.uv[i].x) + LAYER_SHIFT.xy;
      }
    #endif // TECHNIQUE
    return second;
  }
#endif // STROKE_LAYERS
