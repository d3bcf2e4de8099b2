// Algorithm 3: the darkness of the hatch, blended over the triangles of the adjacency primitive.
float hatch(const in HatchingParameters h, const in vec4 tone) {
  #if TECHNIQUE == TECHNIQUE_ADJACENCY
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
