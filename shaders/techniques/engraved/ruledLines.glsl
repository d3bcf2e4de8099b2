// One family of lines: level sets of a function at equal distances, whose width is the tone. As one comes nearer a new line is
// born between every two (the octaves of a ruler), and the share of ink stays the tone throughout.
#include "lineCoverage"

uniform float lineSpacing; // pixels between lines, or 256ths of a tile
#if TONE_MODEL == TONE_MODEL_SHADOW
  uniform float shadowSpacing; // times lineSpacing
  #define WANTED_SPACING (shadowSpacing * lineSpacing)
#else
  #define WANTED_SPACING lineSpacing
#endif // TONE_MODEL
uniform float finestSpacing; // pixels: where lines would lie closer, every other one is left out, so that none shimmer

// How far the edge of a line fades, in pixels.
#define FRINGE 0.5

// The logarithm to base 2 at powers of two, and linear between them: all that continuous octaves need. x: above 0.
float octaves(const in float x) {
  // The bits of a float are its exponent, then 23 of its mantissa.
  return float(floatBitsToInt(x)) * (1.0 / 8388608.0) - 127.0;
}

// The inverse.
float powerOf2(const in float octave) {
  return intBitsToFloat(int(octave * 8388608.0 + 1065353216.0));
}

#ifdef DISSOLVES_SHADOWS
  // Where a shadow dissolves its lines end one by one: the width of a line as a factor on what it would be if all thinned out together. The
  // mean over all lines is 1, so that the tone is the same.
  float lineLeft(const in float line) {
    float gone = min(ENDING * (1.0 - shadowLeft()) / max(shadowLeft(), LEAST_LEFT), MOST_ENDING);
    float kept = gone < 1.0 ? 1.0 - 0.5 * gone : 0.5 / gone;
    // Half a turn from the hash by which widths differ: those that stay are neither the wide ones nor the thin ones.
    return max(1.0 - gone * fract(hash01(line) + 0.5), 0.0) / kept;
  }
#else
  #define lineLeft(line) 1.0
#endif // DISSOLVES_SHADOWS

// The share of a pixel that a line covers. away: from the line, signed. room: half of what the line has. Both in pixels.
#if MEDIUM == MEDIUM_PEN
  #include "technique/penStrokes"
  #define LINE(away, room, line) penCoverage(pen, away, room / oldRoom, spacing, line)
#elif MEDIUM == MEDIUM_WOODCUT
  #include "technique/carving"
  #define LINE(away, room, line) lineCoverage(abs(away), room * cutWidth(cut, line), FRINGE)
  #ifdef DISSOLVES_SHADOWS
    // Rows keep their places at the edges of a shadow, where their cuts widen: a row for each tone would leave crumbs there.
    #define ROW_TONE max(tone, toneEnds.y * shadowTone * shadowLeft())
  #else
    #define ROW_TONE tone
  #endif // DISSOLVES_SHADOWS
#elif defined(FOLLOWS_FORM)
  #define LINE(away, room, line) lineCoverage(abs(away), room * tone, FRINGE)
#else
  #define LINE(away, room, line) lineCoverage(abs(away), room * tone * handWidth(line) * lineLeft(line), FRINGE)
#endif // MEDIUM

// The darkness of a family.
float ruledLines(const in HatchingParameters h, const in Family family, const in float tone) {
  float seen = max(family.seen, max(LEAST_OF_SMOOTH * family.perPixel, 1e-12));
  // Smooth normals space lines evenly over the triangles of a round body; on few triangles they can be far from what is seen.
  float perPixel = clamp(family.perPixel, seen / MOST_OFF_TRIANGLE, seen * MOST_OFF_TRIANGLE);
  float onObject = octaves(WANTED_SPACING / PARTS_OF_TILE * family.rise);
  float onScreen = octaves(WANTED_SPACING * perPixel);
  float octave = max(mix(onObject, onScreen, sizedOnScreen), octaves(finestSpacing * perPixel));
  #if MEDIUM == MEDIUM_WOODCUT
    octave += rowOctaves(ROW_TONE);
  #endif // MEDIUM
  octave = min(octave, family.coarsest);
  float period = powerOf2(ceil(octave));
  // Old lines stay as wide as they would be at just this spacing, which takes the least change as one comes nearer. What room
  // they leave is that of the new ones, which are their equals when the next octave begins.
  float pixels = period / seen;
  float spacing = powerOf2(octave) / seen;
  float x = family.value / period;
  float below = floor(x);
  #if MEDIUM == MEDIUM_PEN
    Pen pen = penFor(h, family, tone, octave);
  #elif MEDIUM == MEDIUM_WOODCUT
    Cut cut = cutFor(h, family, tone, octave);
  #endif // MEDIUM
  float oldRoom = 0.5 * spacing;
  float youngRoom = 0.5 * (pixels - spacing);
  // All that a pixel may lie on: their shares of it add up.
  float covered = 0.0;
  for (int i = 0; i < 3; i++) {
    float line = below + 0.5 * float(i);
    covered += LINE((x - line) * pixels, (i == 1 ? youngRoom : oldRoom), line * period);
  }
  covered = min(covered, 1.0);
  #if MEDIUM == MEDIUM_WOODCUT
    return 1.0 - covered;
  #else
    return covered;
  #endif // MEDIUM
}
