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

// How alike neighbouring levels are: their strokes nest.
#define LEVEL_CORRELATION 0.5

// The field of the map at uv. octaves: by how many the map at its own size would be too fine. Between two levels the
// texture unit interpolates, which makes strokes that are only in the finer one come later, and the others swell; what it
// takes from the variance is given back.
float thresholdAt(const in vec2 uv, const in float octaves) {
  return textureLod(thresholdMap, uv, octaves).r;
}

float levelContrast(const in float octaves) {
  float share = fract(clamp(octaves, 0.0, thresholdMapLevels - 1.0));
  float rest = 1.0 - share;
  return inversesqrt(rest * rest + share * share + 2.0 * rest * share * LEVEL_CORRELATION);
}

// Blends two independent fields without losing variance.
float blendFields(const in float a, const in float b, const in float share) {
  float rest = 1.0 - share;
  return mix(a, b, share) * inversesqrt(rest * rest + share * share);
}

// Φ: the standard normal distribution, to 2e-4.
float normalDistribution(const in float g) {
  return 0.5 + 0.5 * tanh(0.7978845608 * (g + 0.044715 * g * g * g));
}

// Ink ∈ [0, 1] of a blended field g under a tone: decided once, here. The mean over all g is exactly the tone, however
// wide the edge.
float inkAt(const in float g, const in float tone) {
  float h = normalDistribution(g);
  float slope = 0.3989422804 * exp(-0.5 * g * g); // Φ'
  float width = clamp(fwidth(g) * slope * edgePixels, 1e-7, 1.0);
  // Near blank and near full, an edge that reaches beyond [0, 1] would lose some of its ink; draw it elsewhere instead.
  float level = tone;
  if (tone < 0.5 * width) level = sqrt(2.0 * width * tone) - 0.5 * width;
  else if (1.0 - tone < 0.5 * width) level = 1.0 + 0.5 * width - sqrt(2.0 * width * (1.0 - tone));
  return clamp((level - h) / width + 0.5, 0.0, 1.0);
}
