// Tone ∈ [0, 1]: 0 is paper, 1 the darkest hatch image (paper, section 3.4).
#include "toneCurve"

uniform float toneSteps;
uniform vec2 toneEnds; // tones at full light and at none
uniform vec2 exposure; // factor on radiance, and offset (src/material/exposure)
// The ramp that tone is multiplied by, so that highlights stay blank: its slope, and its value at tone 0.
uniform vec2 highlightRamp;

PerToneNormal highlightKept(const in PerToneNormal tone) {
  return tone * clamp(highlightRamp.x * tone + highlightRamp.y, 0.0, 1.0);
}

PerToneNormal toneFromRadiance(const in PerToneNormal radiance) {
  PerToneNormal tone = 1.0 - clamp(radiance, 0.0, 1.0);
  #if TONE_MODEL == TONE_MODEL_TOON
    float last = max(toneSteps - 1.0, 1.0);
    tone = floor(tone * last + 0.5) / last;
  #endif // TONE_MODEL
  // Rounding may take a curve out of the range, and roots of tone and of 1 − tone follow.
  return highlightKept(clamp(curvedTone(tone), 0.0, 1.0));
}

PerToneNormal exposed(const in PerToneNormal radiance) {
  return exposure.x * radiance + exposure.y;
}

#include "darkenedByColor"

// Hollows go beyond the tone of no light, which leaves some paper: to full ink, or with light ink to bare paper.
PerToneNormal deepened(const in PerToneNormal tone) {
  return mix(tone, PerToneNormal(step(toneEnds.x, toneEnds.y)), hollowness());
}

// The tone of a lit surface, shadows included.
PerToneNormal shadedTone(const in HatchingSurface surface) {
  #if TONE_MODEL == TONE_MODEL_SHADOW
    // Light ink draws the lights: it leaves shadows blank, soft edges too.
    if (toneEnds.y <= toneEnds.x) return PerToneNormal(0.0);
    // The share of the light that arrives. Without any light that a shadow could take, nothing is printed.
    PerToneNormal arriving = (surface.radiance + NO_LIGHT) / (surface.radiance + surface.shadowed + NO_LIGHT);
    // Full light prints nothing either, whatever tone the curve gives it.
    PerToneNormal tone = max(toneFromRadiance(arriving) - arriving * toneEnds.x, 0.0);
    #ifdef DISSOLVES_SHADOWS
      tone *= shadowTone * shadowLeft();
    #endif // DISSOLVES_SHADOWS
    return tone;
  #else
    return deepened(darkenedByColor(toneFromRadiance(exposed(surface.radiance)), surface));
  #endif // TONE_MODEL
}

// The tone of the same surface without shadows.
PerToneNormal unshadowedTone(const in HatchingSurface surface) {
  #if TONE_MODEL == TONE_MODEL_SHADOW
    return PerToneNormal(0.0);
  #else
    return deepened(darkenedByColor(toneFromRadiance(exposed(surface.radiance + surface.shadowed)), surface));
  #endif // TONE_MODEL
}
