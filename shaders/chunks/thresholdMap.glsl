// The threshold map: where a texel of the hatch becomes ink. Stored as g = Φ⁻¹(h) of the tone h from which the texel is
// ink, h uniform on [0, 1], so that fields may be blended without losing contrast or tone: for independent g_i,
// Σ w_i g_i / √(Σ w_i²) is standard normal again (Heitz and Neyret, "High-Performance By-Example Noise", 2018).
//
// Its levels are those of the map: drawn, with strokes as wide in texels on each. They lie side by side in one texture
// (src/tam/packThresholds.ts), and beside each, in green, the next coarser one: one plain fetch reads two levels.

uniform highp sampler2D thresholdMap;
uniform float thresholdMapSize; // texels per side of level 0
uniform vec2 thresholdMapTexel; // share of the texture's width and height
uniform float thresholdMapLevels;
uniform float edgePixels; // width of the edge of a stroke

// Variance of g between texels, of a level and of the next coarser one, and their covariance.
uniform vec3 thresholdMoments;

// A field to decide ink from: standard normal, but for the skew of mixed levels.
struct HatchField {
  float g;
  float mixing; // 0 where it comes from one level, 1 half way between two
};

struct ThresholdLevel {
  vec2 corner; // where it begins in the texture
  vec2 side; // of the texture
  float share; // of the next coarser level
  float contrast; // gives back the variance that interpolation takes
  float mixing;
};

// The level for strokes that would be too fine by so many octaves at the map's own size.
float levelFor(const in float octaves) {
  return clamp(octaves, 0.0, thresholdMapLevels - 1.0);
}

// Between two levels both are interpolated: strokes that only the finer one has come later, the others swell, and spacing
// changes evenly.
ThresholdLevel chooseLevel(const in float level) {
  float finer = floor(level);
  float share = level - finer;
  float rest = 1.0 - share;
  float variance = dot(thresholdMoments, vec3(rest * rest, share * share, 2.0 * rest * share));
  float size = thresholdMapSize * exp2(-finer);
  // Every level has a margin of one texel.
  vec2 corner = vec2(2.0 * (thresholdMapSize - size + finer) + 1.0, 1.0);
  return ThresholdLevel(corner * thresholdMapTexel, size * thresholdMapTexel, share, inversesqrt(variance), 4.0 * rest * share * min(2.0 * share, 1.0));
}

float thresholdAt(const in vec2 uv, const in ThresholdLevel level) {
  // Not texture(): it wants derivatives, and some fragments of a quad may not come here.
  vec2 encoded = textureLod(thresholdMap, level.corner + level.side * fract(uv), 0.0).rg;
  return level.contrast * (6.0 * mix(encoded.r, encoded.g, level.share) - 3.0);
}

// The field of four places, blended by their weights.
float blendedField(
  const in vec2 a, const in vec2 b, const in vec2 c, const in vec2 d, const in vec4 weights, const in ThresholdLevel level
) {
  vec4 fields = vec4(thresholdAt(a, level), thresholdAt(b, level), thresholdAt(c, level), thresholdAt(d, level));
  return dot(fields, weights) * inversesqrt(dot(weights, weights));
}

// Φ, the standard normal distribution, to 2e-4, and its slope.
vec2 normalDistribution(const in float g) {
  float h = 1.0 / (1.0 + exp(-1.5957691216 * (g + 0.044715 * g * g * g)));
  return vec2(h, h * (1.0 - h) * 1.5957691216 * (1.0 + 0.134145 * g * g));
}

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
