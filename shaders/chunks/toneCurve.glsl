// From the tone of the light to the printed tone.
#if TONE_CURVE == TONE_CURVE_POINTS
  uniform sampler2D toneCurveTable; // printed tones, by the tone of the light (src/material/toneCurveTable.ts)

  float tabledTone(const in float tone) {
    return textureLod(toneCurveTable, vec2((tone * (TONE_CURVE_TEXELS - 1.0) + 0.5) / TONE_CURVE_TEXELS, 0.5), 0.0).r;
  }

  vec4 tabledTone(const in vec4 tones) {
    return vec4(tabledTone(tones.x), tabledTone(tones.y), tabledTone(tones.z), tabledTone(tones.w));
  }
#endif // TONE_CURVE

PerToneNormal curvedTone(const in PerToneNormal tone) {
  #if TONE_CURVE == TONE_CURVE_PERCEPTUAL
    // Half of the paper is covered at half the lightness of white.
    return 1.0 - lightness(1.0 - tone);
  #elif TONE_CURVE == TONE_CURVE_POINTS
    return tabledTone(tone);
  #else
    return tone;
  #endif // TONE_CURVE
}
