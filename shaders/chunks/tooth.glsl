// The tooth of paper. It lies on the screen; in the tiles of a larger picture it lies on the whole picture.
#include "toothConstants"

uniform sampler2D toothMap; // a standard normal field, low where the paper stands up (src/material/tam/toothMap.ts)
uniform vec2 toothOffset; // of this picture within a larger one, pixels
uniform float toothSize; // pixels to a bump

// The share of their variance that neighbouring texels of the map do not have in common.
#define TOOTH_UNSHARED (3.0 / 19.0)

// Bumps larger than DETAIL_FROM pixels, as in a print, carry smaller ones, or the interpolation of the map would show: DETAIL_FINER
// times as fine, and from DETAIL_TO pixels on as strong as DETAIL.
#define DETAIL_FROM 3.0
#define DETAIL_TO 9.0
#define DETAIL 0.6
#define DETAIL_FINER 3.7

// size: pixels to a bump.
float toothOf(const in float size) {
  vec2 texel = (gl_FragCoord.xy + toothOffset) / size * TOOTH_MAP_BUMP;
  float encoded = textureLod(toothMap, texel / TOOTH_MAP_SIZE, 0.0).r;
  // Gives back the variance that interpolation takes.
  vec2 between = fract(texel - 0.5);
  vec2 variance = 1.0 - 2.0 * between * (1.0 - between) * TOOTH_UNSHARED;
  return (6.0 * encoded - 3.0) * inversesqrt(variance.x * variance.y);
}

float toothField() {
  float detail = DETAIL * smoothstep(DETAIL_FROM, DETAIL_TO, toothSize);
  float coarse = toothOf(toothSize);
  if (detail == 0.0) return coarse;
  // At another size the map is as good as an independent one: variances add.
  return (coarse + detail * toothOf(toothSize / DETAIL_FINER)) * inversesqrt(1.0 + detail * detail);
}
