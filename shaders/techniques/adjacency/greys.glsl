float hatchLayer(const in HatchingParameters h, const in PerToneNormal tone) {
  vec4 tones = vec4(tone);
  return 1.0 - blend(h, vec4(
    lightnessOfHatch(h.uv[0], tones.x), lightnessOfHatch(h.uv[1], tones.y),
    lightnessOfHatch(h.uv[2], tones.z), lightnessOfHatch(h.uv[3], tones.w)
  ));
}
