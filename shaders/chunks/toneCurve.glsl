// From the tone of the light to the printed tone.
#if TONE_CURVE == TONE_CURVE_POINTS
  // A monotone cubic spline: a start value, and the rise over each span (src/material/fitToneCurve.ts). Unused spans add nothing.
  uniform float toneCurveStart;
  uniform vec2 toneCurveSpans[TONE_CURVE_SPANS]; // start of the span, and 1 / its width
  uniform vec3 toneCurveCubics[TONE_CURVE_SPANS]; // coefficients of t, t², t³
#endif // TONE_CURVE

PerToneNormal curvedTone(const in PerToneNormal tone) {
  #if TONE_CURVE == TONE_CURVE_PERCEPTUAL
    // Half of the paper is covered at half the lightness of white.
    return 1.0 - lightness(1.0 - tone);
  #elif TONE_CURVE == TONE_CURVE_POINTS
    PerToneNormal curved = PerToneNormal(toneCurveStart);
    for (int i = 0; i < TONE_CURVE_SPANS; i++) {
      PerToneNormal t = clamp((tone - toneCurveSpans[i].x) * toneCurveSpans[i].y, 0.0, 1.0);
      vec3 c = toneCurveCubics[i];
      curved += t * (c.x + t * (c.y + t * c.z));
    }
    return curved;
  #else
    return tone;
  #endif // TONE_CURVE
}
