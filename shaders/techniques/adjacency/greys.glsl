float hatchLayer(const in HatchingParameters h, const in PerToneNormal tone) {
  vec4 tones = vec4(tone);
  return blend(h, vec4(
    sampleTonalArtMap(h.uv[0], tones.x), sampleTonalArtMap(h.uv[1], tones.y),
    sampleTonalArtMap(h.uv[2], tones.z), sampleTonalArtMap(h.uv[3], tones.w)
  ));
}
