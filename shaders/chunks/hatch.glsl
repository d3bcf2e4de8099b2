uniform float texelPixels; // wanted pixels per texel

#ifdef USE_UNITS_PER_PIXEL
  // The level of a map of so many texels per tile by the depth of the fragment alone (paper, section 3.4).
  float levelByDepth(const in float size) {
    return log2(strokeScale * vUnitsPerPixel * size * texelPixels);
  }
#endif // USE_UNITS_PER_PIXEL

#if TECHNIQUE == TECHNIQUE_ANCHORED || defined(CRISP)
  #include "thresholdMap"
#else
  #include "tonalArtMap"
#endif // TECHNIQUE
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "anchoredHatch"
#endif // TECHNIQUE

#ifdef CRISP
  // Octaves by which the map would be too fine at a fragment.
  float minification(const in vec2 uv) {
    #if LEVEL_RULE == LEVEL_RULE_DEPTH
      return levelByDepth(thresholdMapSize);
    #else
      return log2(thresholdMapSize * texelPixels * max(length(dFdx(uv)), length(dFdy(uv))));
    #endif // LEVEL_RULE
  }
#endif // CRISP

// Algorithm 3: the darkness of one layer of strokes, blended over the triangles of the adjacency primitive.
float hatchLayer(const in HatchingParameters h, const in PerToneNormal tone) {
  #if TECHNIQUE == TECHNIQUE_ANCHORED
    float crowding;
    HatchField field = anchoredField(h.point, h.uAxis, h.vAxis, h.lean, crowding);
    return inkAt(field, tone, crowding);
  #elif defined(CRISP)
    // The same frames and weights, but what is blended is the field, and ink is decided once. All frames of a triangle
    // have the same scale, so one choice of level serves them all.
    float chosen = levelFor(minification(h.uv[0]));
    ThresholdLevel level = chooseLevel(chosen);
    #if LEVEL_RULE == LEVEL_RULE_DEPTH
      vec2 texels = thresholdMapSize * vec2(dFdx(h.uv[0].y), dFdy(h.uv[0].y)); // to a pixel, across the strokes
      float crowding = 0.5 * log2(dot(texels, texels)) - chosen;
    #else
      float crowding = 0.0; // the level sees to it
    #endif // LEVEL_RULE
    #if TECHNIQUE == TECHNIQUE_ADJACENCY
      vec4 fields = vec4(
        thresholdAt(h.uv[0], level), thresholdAt(h.uv[1], level),
        thresholdAt(h.uv[2], level), thresholdAt(h.uv[3], level)
      );
      float g = dot(fields, h.weights) * inversesqrt(dot(h.weights, h.weights));
      return inkAt(HatchField(g, level.mixing), dot(vec4(tone), h.weights) / dot(h.weights, vec4(1.0)), crowding);
    #else
      return inkAt(HatchField(thresholdAt(h.uv[0], level), level.mixing), tone, crowding);
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

// The darkness of the hatch. A second layer takes over as much of the tone as the lights disagree, so that one printed
// over the other, 1 − (1 − T₁)(1 − T₂), they give the tone again.
float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
  #if STROKE_LAYERS == 2
    // Where nothing stays blank, any share of the tone would fill both layers.
    PerToneNormal blank = max(1.0 - tone, 1e-3);
    float share = 0.5 * h.crossing;
    float first = hatchLayer(h, 1.0 - pow(blank, PerToneNormal(1.0 - share)));
    float second = hatchLayer(secondLayer(h), 1.0 - pow(blank, PerToneNormal(share)));
    return 1.0 - (1.0 - first) * (1.0 - second);
  #else
    return hatchLayer(h, tone);
  #endif // STROKE_LAYERS
}
