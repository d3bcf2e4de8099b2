// Turns a field of thresholds into what is printed: ink, or what a dry medium leaves.
uniform float edgePixels; // width of the edge of a stroke

#include "normalDistribution"

// The mix of two skewed fields is not normal: between levels the tone would be up to 0.04 too light. This cubic corrects h; it is fitted
// to generated maps.
float unskew(const in float h, const in float mixing) {
  float x = h - 0.42;
  return h + mixing * h * (1.0 - h) * (1.07 * x * x - 0.14);
}

// Strokes are drawn two texels wide. From CROWDED_FROM octaves finer on they turn into their tone, and at CROWDED octaves none can be
// told from the next.
#define CROWDED_FROM 1.0
#define CROWDED 2.5

// Darkness ∈ [0, 1] of a place that is ink from the tone h on, which is evenly distributed. width: of the edge, in h. The mean over all
// h is the tone, however wide the edge is.
float darkenedFrom(const in float h, const in float tone, const in float width) {
  // Near blank and near full, an edge that reaches beyond [0, 1] would lose some of its ink, so it is moved.
  float nearest = min(tone, 1.0 - tone);
  float moved = sqrt(2.0 * width * nearest) - 0.5 * width;
  float level = nearest < 0.5 * width ? (tone < 0.5 ? moved : 1.0 - moved) : tone;
  return clamp((level - h) / width + 0.5, 0.0, 1.0);
}

// How far strokes have turned into their tone, from 0 to 1. crowding: octaves by which they are finer than drawn.
float crowdedShare(const in float crowding) {
  return smoothstep(CROWDED_FROM, CROWDED, crowding);
}

#if MEDIUM == MEDIUM_DRY
  #include "dryMedium"
#else
  // Ink ∈ [0, 1] of a field under a tone: decided once, here.
  float inkAt(const in HatchField field, const in float tone, const in float crowding) {
    vec2 h = normalDistribution(field.g);
    float ink = darkenedFrom(unskew(h.x, field.mixing), tone, clamp(fwidth(field.g) * h.y * edgePixels, 1e-7, 1.0));
    // At a slant strokes crowd until a pixel holds several. One sample of them would be a stray dot; their mean is the tone.
    return mix(ink, tone, min(edgePixels, 1.0) * crowdedShare(crowding));
  }
#endif // MEDIUM
