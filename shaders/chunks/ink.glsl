// From a field of thresholds to what is printed: ink, or what a dry medium leaves.
uniform float edgePixels; // width of the edge of a stroke

#include "normalDistribution"

// The mix of two skewed fields is not normal. This puts h right again; fitted to what generated maps show between levels,
// where the tone would be up to 0.04 too light.
float unskew(const in float h, const in float mixing) {
  float x = h - 0.42;
  return h + mixing * h * (1.0 - h) * (1.07 * x * x - 0.14);
}

// Octaves by which strokes may be finer than drawn, two texels wide, before they begin to turn into their tone, and by which
// none is told apart.
#define CROWDED_FROM 1.0
#define CROWDED 2.5

// Darkness ∈ [0, 1] where the tone is reached at h, which is evenly distributed: from none to all over so much of h. The mean is
// the tone, however wide that is.
float darkenedFrom(const in float h, const in float tone, const in float width) {
  // Near blank and near full, an edge that reaches beyond [0, 1] would lose some of its ink; draw it elsewhere instead.
  float nearest = min(tone, 1.0 - tone);
  float moved = sqrt(2.0 * width * nearest) - 0.5 * width;
  float level = nearest < 0.5 * width ? (tone < 0.5 ? moved : 1.0 - moved) : tone;
  return clamp((level - h) / width + 0.5, 0.0, 1.0);
}

// How far strokes are crowded. crowding: octaves by which they are finer than drawn.
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
    // At a slant strokes crowd until a pixel holds several; one taken from among them would be a stray dot. Theirs is the tone.
    return mix(ink, tone, min(edgePixels, 1.0) * crowdedShare(crowding));
  }
#endif // MEDIUM
