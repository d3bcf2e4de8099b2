// The field of lines behind a subject, ruled on the sheet: darker behind its lit side, lighter behind its dark side. Each line thins out
// towards an end of its own.
uniform vec3 ink;
uniform float opacity;
uniform float tone;
uniform float contrast; // strength of the light's effect on tone
uniform float spacing; // pixels
uniform vec2 direction; // cosine and sine of the angle of the lines
uniform float extent; // reach of the field, in halves of the subject's size on the sheet
uniform vec4 sheet; // lower left corner in the render target, and size, pixels
uniform vec4 subject; // centre on the sheet, and half the size, pixels

varying vec2 vLit;

#include <common>
#include <dithering_pars_fragment>
#include "lineCoverage"
#include "background/constants"

// A hash in [0, 1) of one end of a line.
float hash01(const in float line, const in float end) {
  uint spread = uint(int(2.0 * line + end)) * GOLDEN_RATIO;
  spread ^= spread >> 15u;
  return float((spread * SECOND_FACTOR) >> 8u) / 16777216.0;
}

void main() {
  vec2 place = gl_FragCoord.xy - sheet.xy;
  vec2 away = place - subject.xy;
  float along = dot(away, direction);
  float across = dot(away, vec2(-direction.y, direction.x)) / spacing;
  float line = floor(across);
  vec2 bySize = away / subject.zw;
  vec2 bySheet = abs(2.0 * place / sheet.zw - 1.0);
  float way = max(length(bySize) / extent, max(bySheet.x, bySheet.y) / RIM);
  // The two ends of a line have unrelated hashes, so near its middle they have no effect.
  float ragged = RAGGED * min(2.0 * abs(along) / (extent * max(subject.z, subject.w)), 1.0);
  float left = 1.0 - smoothstep(1.0 - THINNING, 1.0, way + ragged * (hash01(line, step(0.0, along)) - 0.5));
  float side = clamp(dot(vLit, bySize), -1.0, 1.0);
  float width = spacing * left * min(tone * (1.0 + contrast * side), 1.0);
  float coverage = width > 0.0 ? lineCoverage(abs(across - line - 0.5) * spacing, 0.5 * width, 0.5) : 0.0;
  if (coverage == 0.0) discard;

  gl_FragColor = vec4(ink, opacity * coverage);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <premultiplied_alpha_fragment>
  #include <dithering_fragment>
}
