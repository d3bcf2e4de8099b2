// From the tone of the light to the tone that is printed.
#if TONE_CURVE == TONE_CURVE_POINTS
  // A monotone cubic spline, as a start and what each span adds (src/material/fitToneCurve.ts). Spans that are not in use
  // add nothing.
  uniform float toneCurveStart;
  uniform vec2 toneCurveSpans[TONE_CURVE_SPANS]; // where the span begins, and 1 / its width
  uniform vec3 toneCurveCubics[TONE_CURVE_SPANS]; // coefficients of t, t², t³
#endif // TONE_CURVE

PerToneNormal curvedTone(const in PerToneNormal tone) {
  #if TONE_CURVE == TONE_CURVE_PERCEPTUAL
    // Half the paper is covered where the light looks half as light as white.
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
