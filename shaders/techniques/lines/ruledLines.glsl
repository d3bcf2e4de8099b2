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

#if TECHNIQUE == TECHNIQUE_PEN
  #include "technique/penStrokes"
#elif TECHNIQUE == TECHNIQUE_WOODCUT
  #include "technique/carving"
  #ifdef DISSOLVES_SHADOWS
    // The tone that the spacing of cut rows depends on: constant across the edges of a shadow, where cuts widen, since a row for each tone
    // would leave crumbs there.
    #define ROW_TONE max(tone, toneEnds.y * shadowTone * shadowLeft())
  #else
    #define ROW_TONE tone
  #endif // DISSOLVES_SHADOWS
#endif // TECHNIQUE
#if TECHNIQUE != TECHNIQUE_PEN
  #define youngAt 1
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
  float old = floor(x + 0.5);
  float oldRoom = 0.5 * spacing;
  float youngRoom = 0.5 * (pixels - spacing);
  #if TECHNIQUE == TECHNIQUE_PEN
    Pen pen = penFor(h, family, tone, octave);
    float thereYoung = thereOn(pen, youngRoom / oldRoom);
    // The line in whose room the pixel lies comes first: in light tones no other touches it.
    float fromOld = abs(x - old) * pixels;
    int youngAt = 0.5 * pixels - fromOld - youngRoom < fromOld - oldRoom ? 0 : 1;
  #elif TECHNIQUE == TECHNIQUE_WOODCUT
    Cut cut = cutFor(h, family, tone, octave);
  #endif // TECHNIQUE
  float side = x < old ? -0.5 : 0.5;
  // Sums over all lines that may touch the pixel: the nearest old one, the next on the pixel's side, and the young one between.
  float covered = 0.0;
  for (int i = 0; i < 3; i++) {
    bool isYoung = i == youngAt;
    float line = old + side * (isYoung ? 1.0 : i < 2 ? 0.0 : 2.0);
    float away = (x - line) * pixels;
    float room = isYoung ? youngRoom : oldRoom;
    #if TECHNIQUE == TECHNIQUE_PEN
      covered += penCoverage(pen, away, room, isYoung ? thereYoung : 1.0, spacing, line * period);
    #elif TECHNIQUE == TECHNIQUE_WOODCUT
      covered += lineCoverage(abs(away), room * cutWidth(cut, line * period), FRINGE);
    #elif defined(FOLLOWS_FORM)
      covered += lineCoverage(abs(away), room * tone, FRINGE);
    #else
      covered += lineCoverage(abs(away), room * tone * handWidth(line * period) * lineLeft(line * period), FRINGE);
    #endif // TECHNIQUE
  }
  covered = min(covered, 1.0);
  #if TECHNIQUE == TECHNIQUE_WOODCUT
    return 1.0 - covered;
  #else
    return covered;
  #endif // TECHNIQUE
}
