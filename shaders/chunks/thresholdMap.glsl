// The threshold map: where a texel of the hatch becomes ink. Stored as g = Φ⁻¹(h) of the tone h from which the texel is
// ink, h uniform on [0, 1], so that fields may be blended without losing contrast or tone: for independent g_i,
// Σ w_i g_i / √(Σ w_i²) is standard normal again (Heitz and Neyret, "High-Performance By-Example Noise", 2018).

uniform highp sampler2D thresholdMap;

// Φ: the standard normal distribution, to 2e-4.
float normalDistribution(const in float g) {
  return 0.5 + 0.5 * tanh(0.7978845608 * (g + 0.044715 * g * g * g));
}

// Ink ∈ [0, 1] of a blended field g under a tone: decided once, here, with an edge as wide as `edgePixels` on the screen.
// The mean over all g is exactly the tone, at any width of the edge.
float inkAt(const in float g, const in float tone, const in float edgePixels) {
  float h = normalDistribution(g);
  float slope = 0.3989422804 * exp(-0.5 * g * g); // Φ'
  float width = clamp(fwidth(g) * slope * edgePixels, 1e-5, 1.0);
  // Near blank and near full, an edge that reaches beyond [0, 1] would lose some of its ink; draw it elsewhere instead.
  float level = tone;
  if (tone < 0.5 * width) level = sqrt(2.0 * width * tone) - 0.5 * width;
  else if (1.0 - tone < 0.5 * width) level = 1.0 + 0.5 * width - sqrt(2.0 * width * (1.0 - tone));
  return clamp((level - h) / width + 0.5, 0.0, 1.0);
}
