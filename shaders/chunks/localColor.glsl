// The tone and the tint of the surface's own colour.
#include "localDarkness"

uniform float mapBlur; // levels by which the map is read coarser for its tone than it is seen
uniform float colorFill; // share of it that is printed on the paper

// The colour that becomes tone: a map without details that are finer than strokes can show; where it is cut out, as it is.
// plain: the colour without the map.
vec3 tonedColor(const in vec3 plain, const in vec3 seen) {
  #if defined(USE_MAP) && !defined(DECODE_VIDEO_TEXTURE)
    if (mapBlur > 0.0) {
      vec4 coarse = texture2D(map, vMapUv, mapBlur);
      if (coarse.a >= OPAQUE_TEXEL) return plain * coarse.rgb;
    }
  #endif // USE_MAP
  return seen;
}

vec3 filledColor(const in vec3 color) {
  return mix(vec3(1.0), color, colorFill);
}
