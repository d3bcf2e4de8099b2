// One family of lines: level sets of a function at equal distances, whose width is the tone. As the camera comes nearer a new line appears
// between every two (the octaves of a ruler), and the share of ink stays the tone throughout.
#include "lineCoverage"

#include "technique/lineSpacing"

#ifdef DISSOLVES_SHADOWS
  // A factor on the width of a line where a shadow dissolves: lines end one by one, instead of all thinning out together. The mean over all
  // lines is 1, so the tone stays.
  float lineLeft(const in float line) {
    float gone = min(ENDING * (1.0 - shadowLeft()) / max(shadowLeft(), LEAST_LEFT), MOST_ENDING);
    float kept = gone < 1.0 ? 1.0 - 0.5 * gone : 0.5 / gone;
    // Half a turn from the hash of widths, so that the lines that stay are neither the widest nor the thinnest.
    return max(1.0 - gone * fract(hash01(line) + 0.5), 0.0) / kept;
  }
#else
  #define lineLeft(line) 1.0
#endif // DISSOLVES_SHADOWS

// The share of a pixel that a line covers. away: signed distance from the line. room: half of the room of the line. Both in pixels.
#if TECHNIQUE == TECHNIQUE_PEN
  #include "technique/penStrokes"
  #define LINE(away, room, line) penCoverage(pen, away, room / oldRoom, spacing, line)
#elif TECHNIQUE == TECHNIQUE_WOODCUT
  #include "technique/carving"
  #define LINE(away, room, line) lineCoverage(abs(away), room * cutWidth(cut, line), FRINGE)
  #ifdef DISSOLVES_SHADOWS
    // The tone that the spacing of cut rows depends on: constant across the edges of a shadow, where cuts widen, since a row for each tone
    // would leave crumbs there.
    #define ROW_TONE max(tone, toneEnds.y * shadowTone * shadowLeft())
  #else
    #define ROW_TONE tone
  #endif // DISSOLVES_SHADOWS
#elif defined(FOLLOWS_FORM)
  #define LINE(away, room, line) lineCoverage(abs(away), room * tone, FRINGE)
#else
  #define LINE(away, room, line) lineCoverage(abs(away), room * tone * handWidth(line) * lineLeft(line), FRINGE)
#endif // TECHNIQUE

// The darkness of a family.
float ruledLines(const in HatchingParameters h, const in Family family, const in float tone) {
  float trianglePerPixel = trianglePerPixelOf(family);
  float octave = octaveOf(family, trianglePerPixel);
  #if TECHNIQUE == TECHNIQUE_WOODCUT
    octave += rowOctaves(ROW_TONE);
  #endif // TECHNIQUE
  octave = min(octave, family.coarsest);
  float period = powerOf2(ceil(octave));
  // Old lines stay as wide as at exactly this spacing, which changes least as the camera comes nearer. The room that they leave is that of
  // the new ones, which are as wide when the next octave begins.
  float pixels = period / trianglePerPixel;
  float spacing = powerOf2(octave) / trianglePerPixel;
  float x = family.value / period;
  float below = floor(x);
  #if TECHNIQUE == TECHNIQUE_PEN
    Pen pen = penFor(h, family, tone, octave);
  #elif TECHNIQUE == TECHNIQUE_WOODCUT
    Cut cut = cutFor(h, family, tone, octave);
  #endif // TECHNIQUE
  float oldRoom = 0.5 * spacing;
  float youngRoom = 0.5 * (pixels - spacing);
  // Sums over all lines that may touch the pixel.
  float covered = 0.0;
  for (int i = 0; i < 3; i++) {
    float line = below + 0.5 * float(i);
    covered += LINE((x - line) * pixels, (i == 1 ? youngRoom : oldRoom), line * period);
  }
  covered = min(covered, 1.0);
  #if TECHNIQUE == TECHNIQUE_WOODCUT
    return 1.0 - covered;
  #else
    return covered;
  #endif // TECHNIQUE
}
