// Tone ∈ [0, 1]: 0 is paper, 1 the darkest hatch image (paper, section 3.4).
#include "toneCurve"

uniform float toneSteps;
uniform vec2 toneEnds; // the tones that are printed where all light arrives, and where none does
uniform vec2 exposure; // what radiance is multiplied by, and what is added (src/material/exposure)
// The ramp that tone is multiplied by, so that highlights stay blank paper: its slope, and its height at tone 0.
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
  // A curve of points may leave the range by a rounding error; what follows takes roots of tone and of 1 − tone.
  return highlightKept(clamp(curvedTone(tone), 0.0, 1.0));
}

PerToneNormal exposed(const in PerToneNormal radiance) {
  return exposure.x * radiance + exposure.y;
}

// A dark colour brings the tone nearer to that of no light at all: with dark ink, it is printed over it.
PerToneNormal darkenedByColor(const in PerToneNormal tone, const in HatchingSurface surface) {
  return mix(tone, PerToneNormal(toneEnds.y), surface.darkness);
}

// Hollows go beyond the tone of no light, where some paper shows: to the darkest image, or for chalk to bare paper.
PerToneNormal deepened(const in PerToneNormal tone) {
  return mix(tone, PerToneNormal(step(toneEnds.x, toneEnds.y)), hollowness());
}

// The tone that the light of the surface prints, shadows included.
PerToneNormal shadedTone(const in HatchingSurface surface) {
  #if TONE_MODEL == TONE_MODEL_SHADOW
    // Light ink draws the lights: its shadows are blank, soft edges too.
    if (toneEnds.y <= toneEnds.x) return PerToneNormal(0.0);
    // The share of the light that arrives. Where there is none that shadows could take, nothing is printed.
    PerToneNormal arriving = (surface.radiance + NO_LIGHT) / (surface.radiance + surface.shadowed + NO_LIGHT);
    // Nor where all of it arrives, whatever a curve makes of blank paper.
    PerToneNormal tone = max(toneFromRadiance(arriving) - arriving * toneEnds.x, 0.0);
    #ifdef DISSOLVES_SHADOWS
      tone *= shadowTone * shadowLeft();
    #endif // DISSOLVES_SHADOWS
    return tone;
  #else
    return deepened(darkenedByColor(toneFromRadiance(exposed(surface.radiance)), surface));
  #endif // TONE_MODEL
}

// The tone that it would print if nothing cast shadows.
PerToneNormal unshadowedTone(const in HatchingSurface surface) {
  #if TONE_MODEL == TONE_MODEL_SHADOW
    return PerToneNormal(0.0);
  #else
    return deepened(darkenedByColor(toneFromRadiance(exposed(surface.radiance + surface.shadowed)), surface));
  #endif // TONE_MODEL
}
