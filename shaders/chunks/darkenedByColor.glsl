// A dark colour brings the tone towards that of no light, as if printed over it with dark ink.
PerToneNormal darkenedByColor(const in PerToneNormal tone, const in HatchingSurface surface) {
  return mix(tone, PerToneNormal(toneEnds.y), surface.darkness);
}
