// The threshold map: where a texel of the hatch becomes ink. Stored as g = Φ⁻¹(h) of the tone h from which the texel is
// ink, h uniform on [0, 1], so that fields may be blended without losing contrast or tone: for independent g_i,
// Σ w_i g_i / √(Σ w_i²) is standard normal again (Heitz and Neyret, "High-Performance By-Example Noise", 2018).
//
// Its levels are those of the map: drawn, with strokes as wide in texels on each.

uniform highp sampler2D thresholdMap;
uniform float thresholdMapSize; // texels per side of level 0
uniform float thresholdMapLevels;
uniform float texelPixels; // wanted pixels per texel
uniform float edgePixels; // width of the edge of a stroke

uniform vec2 thresholdMoments; // variance of g between texels, and covariance between neighbouring levels

// The share of an octave, at either end, that a level serves alone.
#define LEVEL_FADE_START 0.2

// The level for strokes that would be too fine by so many octaves at the map's own size. Between two levels the texture
// unit interpolates: strokes that only the finer one has come later, the others swell.
struct ThresholdLevel {
  float lod;
  float contrast; // gives back the variance that interpolation takes
};

ThresholdLevel chooseLevel(const in float octaves) {
  float level = clamp(octaves, 0.0, thresholdMapLevels - 1.0);
  // A mix of two levels is not quite normal, and tone with it: the less of the way they are mixed the better.
  float share = smoothstep(LEVEL_FADE_START, 1.0 - LEVEL_FADE_START, fract(level));
  float rest = 1.0 - share;
  float variance = thresholdMoments.x * (rest * rest + share * share) + 2.0 * rest * share * thresholdMoments.y;
  return ThresholdLevel(floor(level) + share, inversesqrt(variance));
}

float thresholdAt(const in vec2 uv, const in ThresholdLevel level) {
  return level.contrast * (6.0 * textureLod(thresholdMap, uv, level.lod).r - 3.0);
}

// Blends two independent fields without losing variance.
float blendFields(const in float a, const in float b, const in float share) {
  float rest = 1.0 - share;
  return mix(a, b, share) * inversesqrt(rest * rest + share * share);
}

// Φ, the standard normal distribution, to 2e-4, and its slope.
vec2 normalDistribution(const in float g) {
  float h = 1.0 / (1.0 + exp(-1.5957691216 * (g + 0.044715 * g * g * g)));
  return vec2(h, h * (1.0 - h) * 1.5957691216 * (1.0 + 0.134145 * g * g));
}

// Ink ∈ [0, 1] of a blended field g under a tone: decided once, here. The mean over all g is exactly the tone, however
// wide the edge.
float inkAt(const in float g, const in float tone) {
  vec2 h = normalDistribution(g);
  float width = clamp(fwidth(g) * h.y * edgePixels, 1e-7, 1.0);
  // Near blank and near full, an edge that reaches beyond [0, 1] would lose some of its ink; draw it elsewhere instead.
  float level = tone;
  if (tone < 0.5 * width) level = sqrt(2.0 * width * tone) - 0.5 * width;
  else if (1.0 - tone < 0.5 * width) level = 1.0 + 0.5 * width - sqrt(2.0 * width * (1.0 - tone));
  return clamp((level - h.x) / width + 0.5, 0.0, 1.0);
}
