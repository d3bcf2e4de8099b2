float hatchLayer(const in HatchingParameters h, const in float tone) {
  return sampleTonalArtMap(h.uv, tone);
}
