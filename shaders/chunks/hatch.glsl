#if TECHNIQUE == TECHNIQUE_ANCHORED || defined(CRISP)
  #include "thresholdMap"
#else
  #include "tonalArtMap"
#endif // TECHNIQUE
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "anchoredHatch"
#endif // TECHNIQUE

#ifdef CRISP
  // Octaves by which the map would be too fine at a fragment, from the screen derivatives of its coordinates.
  float minification(const in vec2 uv) {
    return log2(thresholdMapSize * texelPixels * max(length(dFdx(uv)), length(dFdy(uv))));
  }
#endif // CRISP

// Algorithm 3: the darkness of the hatch, blended over the triangles of the adjacency primitive.
float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
  #if TECHNIQUE == TECHNIQUE_ANCHORED
    return inkAt(anchoredField(vRestPosition, h.uAxis, h.vAxis, vUnitsPerPixel), tone);
  #elif defined(CRISP)
    // The same frames and weights, but what is blended is the field, and ink is decided once. All frames of a triangle
    // have the same scale, so one choice of level serves them all.
    ThresholdLevel level = chooseLevel(minification(h.uv[0]));
    #if TECHNIQUE == TECHNIQUE_ADJACENCY
      vec4 fields = vec4(
        thresholdAt(h.uv[0], level), thresholdAt(h.uv[1], level),
        thresholdAt(h.uv[2], level), thresholdAt(h.uv[3], level)
      );
      float g = dot(fields, h.weights) * inversesqrt(dot(h.weights, h.weights));
      return inkAt(HatchField(g, level.mixing), dot(vec4(tone), h.weights) / dot(h.weights, vec4(1.0)));
    #else
      return inkAt(HatchField(thresholdAt(h.uv[0], level), level.mixing), tone);
    #endif // TECHNIQUE
  #elif TECHNIQUE == TECHNIQUE_ADJACENCY
    vec4 tones = vec4(tone);
    vec4 darkness = vec4(
      sampleTonalArtMap(h.uv[0], tones.x), sampleTonalArtMap(h.uv[1], tones.y),
      sampleTonalArtMap(h.uv[2], tones.z), sampleTonalArtMap(h.uv[3], tones.w)
    );
    // f of c is 1, so the sum of the weights is at least 1.
    return dot(darkness, h.weights) / dot(h.weights, vec4(1.0));
  #else
    return sampleTonalArtMap(h.uv[0], tone);
  #endif // TECHNIQUE
}
