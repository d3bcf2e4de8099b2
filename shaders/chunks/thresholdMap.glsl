// The threshold map has the tone h from which on each texel of the hatch is ink, stored as g = Φ⁻¹(h), h uniform on [0, 1], so that fields
// may be blended without losing contrast or tone: for independent g_i, Σ w_i g_i / √(Σ w_i²) is standard normal again (Heitz and Neyret,
// "High-Performance By-Example Noise", 2018).
//
// Its levels are those of the tonal art map, whose strokes are equally wide in texels. They lie side by side in one texture
// (src/material/tam/ThresholdTexture.ts). The green channel of each holds the next coarser level, so that one fetch reads two levels.

uniform highp sampler2D thresholdMap;
uniform float thresholdMapSize; // texels per side of level 0
uniform vec2 thresholdMapTexel; // texel size, as a share of the texture
uniform float thresholdMapLevels;

// Variances of g between texels on a level and on the next coarser one, and their covariance.
uniform vec3 thresholdMoments;

// A field that is compared with a tone: standard normal, except for the skew of mixed levels.
struct HatchField {
  float g;
  float mixing; // 0 on one level, 1 half way between two
};

struct ThresholdLevel {
  vec2 corner; // lower left corner in the texture, texels
  vec2 side; // side, texels
  float share; // share of the next coarser level
  float contrast; // factor that restores the variance lost by interpolation
  float mixing;
};

// The level that compensates for strokes that are too fine by so many octaves on level 0.
float levelFor(const in float octaves) {
  return clamp(octaves, 0.0, thresholdMapLevels - 1.0);
}

// The level and the share of the next one. Interpolating the fields lets strokes that only the finer level has appear late, while the
// others swell, and spacing changes evenly.
ThresholdLevel chooseLevel(const in float level) {
  float finer = floor(level);
  float share = level - finer;
  float rest = 1.0 - share;
  float variance = dot(thresholdMoments, vec3(rest * rest, share * share, 2.0 * rest * share));
  float size = thresholdMapSize * exp2(-finer);
  // Each level has a margin of one texel.
  vec2 corner = vec2(2.0 * (thresholdMapSize - size + finer) + 1.0, 1.0);
  float mixing = 4.0 * rest * share * min(2.0 * share, 1.0);
  return ThresholdLevel(corner * thresholdMapTexel, size * thresholdMapTexel, share, inversesqrt(variance), mixing);
}

// The stored values: on the level, and on the next coarser one.
vec2 thresholdsAt(const in vec2 uv, const in ThresholdLevel level) {
  // Not texture(), which needs derivatives: some fragments of a quad may not get here.
  return textureLod(thresholdMap, level.corner + level.side * fract(uv), 0.0).rg;
}

// The field of one sample.
float thresholdAt(const in vec2 uv, const in ThresholdLevel level) {
  vec2 thresholds = thresholdsAt(uv, level);
  return level.contrast * (6.0 * mix(thresholds.r, thresholds.g, level.share) - 3.0);
}

// The field of four samples, blended by weights.
float blendedField(
  const in vec2 a, const in vec2 b, const in vec2 c, const in vec2 d, const in vec4 weights, const in ThresholdLevel level
) {
  // Blending comes first: it is linear, so the rest is computed once.
  vec2 blended = weights.x * thresholdsAt(a, level) + weights.y * thresholdsAt(b, level)
    + weights.z * thresholdsAt(c, level) + weights.w * thresholdsAt(d, level);
  float g = 6.0 * mix(blended.r, blended.g, level.share) - 3.0 * dot(weights, vec4(1.0));
  return level.contrast * g * inversesqrt(dot(weights, weights));
}
