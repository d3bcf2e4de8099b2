// White lines cut out of a black block, as in a woodcut. A gouge enters at a point, widens and leaves again: each line is a row of wedges.
// The black between them ends in points too.

#include "technique/strokeLengths"

struct Cut {
  float middle; // mean width as a share of the room; beyond [0, 1] most of the row is blank, or all cut away
  vec4 waves; // two coordinates along the lines in units of cuts, at both lengths
  vec2 shares; // share of the second length, and of the first coordinate
  float swell;
  Family family;
};

// Octaves by which the spacing of rows grows.
float rowOctaves(const in float tone) {
  return clamp(octaves(RARE / max(min(tone, 1.0 - tone), 1e-4)), 0.0, 2.0);
}

Cut cutFor(const in HatchingParameters h, const in Family family, const in float tone, const in float octave) {
  Cut cut;
  cut.family = family;
  float white = 1.0 - tone;
  float rare = min(white, tone);
  // The white share is the mean of clamp(middle + swell u, 0, 1) for u uniform in [−1, 1].
  float swell = differing(family, octave) * min(SWELL, SWELL_SHARE * rare);
  float middle = rare < swell ? sqrt(4.0 * swell * rare) - swell : rare;
  cut.middle = white < 0.5 ? middle : 1.0 - middle;
  Along along = alongLines(h, family);
  vec2 wedges = along.places / along.period;
  cut.waves = vec4(wedges, 0.5 * wedges);
  cut.shares = vec2(along.longer, along.share);
  // Blended waves are flatter.
  vec2 rest = 1.0 - cut.shares;
  vec2 left = cut.shares * cut.shares + rest * rest;
  cut.swell = swell * inversesqrt(left.x * left.y);
  return cut;
}

// A wave that rises slowly and falls fast, uniform in [−1, 1].
vec4 gouge(const in vec4 x) {
  vec4 t = fract(x);
  return 2.0 * min(t / WIDENING, (1.0 - t) / (1.0 - WIDENING)) - 1.0;
}

float cutWidth(const in Cut cut, const in float line) {
  vec4 waves = gouge(cut.waves + turnOf(abs(numberOf(line, cut.family))));
  vec2 lengths = mix(waves.xy, waves.zw, cut.shares.x);
  return clamp(cut.middle + cut.swell * mix(lengths.y, lengths.x, cut.shares.y), 0.0, 1.0);
}
