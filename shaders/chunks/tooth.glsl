// The tooth of paper, fixed to the screen. In the tiles of a larger picture it is fixed to the whole picture.
#include "toothConstants"

uniform sampler2D toothMap; // standard normal field, low where paper fibres rise (src/material/tam/toothMap.ts)
uniform vec2 toothOffset; // offset of this picture in a larger one, pixels
uniform float paperGrainSize; // pixels per bump

// The share of variance that neighbouring texels of the map do not share.
#define TOOTH_UNSHARED (3.0 / 19.0)

// Bumps larger than DETAIL_FROM pixels, as in a print, get smaller ones on top, or the interpolation of the map would show: DETAIL_FINER
// times as fine, and of strength DETAIL from DETAIL_TO pixels on.
#define DETAIL_FROM 3.0
#define DETAIL_TO 9.0
#define DETAIL 0.6
#define DETAIL_FINER 3.7

// size: pixels per bump.
float toothOf(const in float size) {
  vec2 texel = (gl_FragCoord.xy + toothOffset) / size * TOOTH_MAP_BUMP;
  float encoded = textureLod(toothMap, texel / TOOTH_MAP_SIZE, 0.0).r;
  // Restores the variance lost by interpolation.
  vec2 between = fract(texel - 0.5);
  vec2 variance = 1.0 - 2.0 * between * (1.0 - between) * TOOTH_UNSHARED;
  return (6.0 * encoded - 3.0) * inversesqrt(variance.x * variance.y);
}

float toothField() {
  float detail = DETAIL * smoothstep(DETAIL_FROM, DETAIL_TO, paperGrainSize);
  float coarse = toothOf(paperGrainSize);
  if (detail == 0.0) return coarse;
  // At another scale the map counts as independent: variances add.
  return (coarse + detail * toothOf(paperGrainSize / DETAIL_FINER)) * inversesqrt(1.0 + detail * detail);
}
