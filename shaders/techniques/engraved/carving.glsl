// Lines that are cut white out of the block, as in a woodcut. A gouge goes in at a point, widens and comes out again: each line is a
// row of wedges. What they leave between them is black, and ends in points too.

// How far a cut swells and narrows from its mean, as a share of its room. Less white than this is left by separate wedges.
#define SWELL 0.42
// Length of a wedge, in distances between lines, and the share of it in which it widens.
#define CUT_LENGTH 11.0
#define WIDENING 0.7

struct Cut {
  float middle; // width in the mean, as a share of the room; beyond [0, 1] most of the row is blank, or all cut away
  vec4 waves; // two coordinates along the lines in wedges, at the two lengths
  vec2 shares; // of the second length, and of the first coordinate
  float swell;
  #ifdef FOLLOWS_FORM
    float repeat; // a distance between lines, in units of their values: what belongs to one belongs to the next so far away too
  #endif // FOLLOWS_FORM
};

// period: the distance between old lines. into: the octave, from 0 to 1.
Cut cutFor(const in Family family, const in float tone, const in float period, const in float into) {
  Cut cut;
  #ifdef FOLLOWS_FORM
    cut.repeat = powerOf2(family.coarsest);
  #endif // FOLLOWS_FORM
  float white = 1.0 - tone;
  float rare = min(white, tone);
  // The mean of clamp(middle + SWELL u, 0, 1), for u even within [−1, 1], is what is white.
  float middle = rare < SWELL ? sqrt(4.0 * SWELL * rare) - SWELL : rare;
  cut.middle = white < 0.5 ? middle : 1.0 - middle;
  vec2 wedges = family.place.xy / (CUT_LENGTH * period);
  cut.waves = vec4(wedges, 2.0 * wedges);
  cut.shares = vec2(smoothstep(0.2, 0.8, into), family.place.z);
  // Waves that are mixed are flatter.
  vec2 rest = 1.0 - cut.shares;
  vec2 left = cut.shares * cut.shares + rest * rest;
  cut.swell = SWELL * inversesqrt(left.x * left.y);
  return cut;
}

// Rises slowly and falls fast, evenly within [−1, 1].
vec4 gouge(const in vec4 x) {
  vec4 t = fract(x);
  return 2.0 * min(t / WIDENING, (1.0 - t) / (1.0 - WIDENING)) - 1.0;
}

float cutWidth(const in Cut cut, const in float line) {
  #ifdef FOLLOWS_FORM
    // The same on both sides of a seam.
    float number = abs(line - cut.repeat * round(line / cut.repeat));
  #else
    float number = line;
  #endif // FOLLOWS_FORM
  vec4 waves = gouge(cut.waves + lotOf(number));
  vec2 lengths = mix(waves.xy, waves.zw, cut.shares.x);
  return clamp(cut.middle + cut.swell * mix(lengths.y, lengths.x, cut.shares.y), 0.0, 1.0);
}

#define WIDTH_OF(line) cutWidth(cut, line)
