#if TECHNIQUE == TECHNIQUE_ANCHORED || defined(CRISP)
  #include "thresholdMap"

  uniform float edgePixels;
#else
  #include "tonalArtMap"
#endif // TECHNIQUE
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "anchoredHatch"
#endif // TECHNIQUE

// Algorithm 3: the darkness of the hatch, blended over the triangles of the adjacency primitive.
float hatch(const in HatchingParameters h, const in vec4 tone) {
  #if TECHNIQUE == TECHNIQUE_ANCHORED
    return inkAt(anchoredField(vRestPosition, h.uAxis, h.vAxis, vUnitsPerPixel), tone.x, edgePixels);
  #elif defined(CRISP)
    // The same frames and weights, but what is blended is the field, and ink is decided once.
    #if TECHNIQUE == TECHNIQUE_ADJACENCY
      vec4 field = vec4(
        texture(thresholdMap, h.uv[0]).r, texture(thresholdMap, h.uv[1]).r,
        texture(thresholdMap, h.uv[2]).r, texture(thresholdMap, h.uv[3]).r
      );
      float blended = dot(field, h.weights) * inversesqrt(dot(h.weights, h.weights));
      return inkAt(blended, dot(tone, h.weights) / dot(h.weights, vec4(1.0)), edgePixels);
    #else
      return inkAt(texture(thresholdMap, h.uv[0]).r, tone.x, edgePixels);
    #endif // TECHNIQUE
  #elif TECHNIQUE == TECHNIQUE_ADJACENCY
    vec4 darkness = vec4(
      sampleTonalArtMap(h.uv[0], tone.x), sampleTonalArtMap(h.uv[1], tone.y),
      sampleTonalArtMap(h.uv[2], tone.z), sampleTonalArtMap(h.uv[3], tone.w)
    );
    // f of c is 1, so the sum of the weights is at least 1.
    return dot(darkness, h.weights) / dot(h.weights, vec4(1.0));
  #else
    return sampleTonalArtMap(h.uv[0], tone.x);
  #endif // TECHNIQUE
}
