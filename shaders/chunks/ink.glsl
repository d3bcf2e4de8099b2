// Turns a field of thresholds into print: ink, or the mark of pencil or chalk.
uniform float edgePixels; // width of the edge of a stroke

#include "normalDistribution"

// Corrects h: a blend of two skewed fields is not normal, and tones between levels would be up to 0.04 too light. The cubic is fitted to
// generated maps.
float unskew(const in float h, const in float mixing) {
  float x = h - 0.42;
  return h + mixing * h * (1.0 - h) * (1.07 * x * x - 0.14);
}

// Strokes are two texels wide. From CROWDED_FROM octaves finer on they fade into a flat tone, and at CROWDED octaves they are one.
#define CROWDED_FROM 1.0
#define CROWDED 2.5

// Darkness ∈ [0, 1] of a place that becomes ink at the tone h; h is uniform. width: of the edge, in h. The mean over all h is the tone for
// any width.
float darkenedFrom(const in float h, const in float tone, const in float width) {
  // Near blank and near full the edge is moved: beyond [0, 1] it would lose ink.
  float nearest = min(tone, 1.0 - tone);
  float moved = sqrt(2.0 * width * nearest) - 0.5 * width;
  float level = nearest < 0.5 * width ? (tone < 0.5 ? moved : 1.0 - moved) : tone;
  return clamp((level - h) / width + 0.5, 0.0, 1.0);
}

// The share to which strokes have faded into a flat tone. crowding: octaves by which they are finer than drawn.
float crowdedShare(const in float crowding) {
  return smoothstep(CROWDED_FROM, CROWDED, crowding);
}

#if TECHNIQUE == TECHNIQUE_DRY_MEDIA
  #include "dryMedia"
#else
  // The ink ∈ [0, 1] of a field at a tone.
  float inkAt(const in HatchField field, const in float tone, const in float crowding) {
    vec2 h = normalDistribution(field.g);
    float ink = darkenedFrom(unskew(h.x, field.mixing), tone, clamp(fwidth(field.g) * h.y * edgePixels, 1e-7, 1.0));
    // At grazing angles a pixel holds several strokes. A single sample would alias; their mean is the tone.
    return mix(ink, tone, min(edgePixels, 1.0) * crowdedShare(crowding));
  }
#endif // TECHNIQUE
