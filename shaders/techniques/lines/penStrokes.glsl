// Lines drawn in strokes of a pen. Each stroke begins thin, swells and tapers off. Light tones have fewer strokes, of the width of the nib.
#include "technique/strokeLengths"
#include "technique/strokeHashes"

// The share of a line that is lost to the gaps and the tapered ends of its strokes where the gaps are widest.
#define LOST (0.5 * STROKE_GAP + TAPER / 3.0)

struct Pen {
  Family family;
  Along along;
  float tone;
  float open; // size of the gaps between strokes
  float allFrom; // tone from which on no stroke is left out
  float width; // width of a stroke in its middle, as a share of the room of a line
  float widest; // the greatest width of any stroke there
  float strays; // how far strokes lie off their lines at most, in distances between lines
};

// The integral of the ink of a growing stroke: a ramp from 0 to 1, and less where it is short.
float rampSum(const in float x) {
  float grown = min(x / STROKE_GROWTH, 1.0);
  float sum = grown * grown * (0.5 - SHORTENING_OF_INK * (0.5 - grown / 3.0));
  return STROKE_GROWTH * sum + max(x - STROKE_GROWTH, 0.0);
}

Pen penFor(const in HatchingParameters h, const in Family family, const in float tone, const in float octave) {
  float allFrom = ALL_FROM * differing(family, octave);
  float light = max(1.0 - tone / CLOSED_FROM, 0.0);
  float open = light * light;
  float there = (rampSum(tone) - rampSum(max(tone - allFrom, 0.0))) / allFrom;
  float width = tone / max(there * (1.0 - LOST * open), 1e-4);
  width = tone < allFrom ? min(width, NIB) : width;
  float uneven = irregularity * open;
  float widest = width * (1.0 + 0.5 * WIDTH_SPREAD * uneven);
  return Pen(family, alongLines(h, family), tone, open, allFrom, width, widest, uneven * (0.5 * LEANING + 0.25 * BENDING));
}

// The hash below which strokes exist if a given share of them does. Each appears over a part BIRTH of all hashes.
float bornBelow(const in float share) {
  if (share < 0.5 * BIRTH) return sqrt(2.0 * BIRTH * share);
  return share < 1.0 - 0.5 * BIRTH ? share + 0.5 * BIRTH : 1.0 + BIRTH - sqrt(2.0 * BIRTH * (1.0 - share));
}

// The delay of the start of a stroke, as a share of the mean length.
float latenessOf(const in float chance) {
  return LATENESS * fract(LATE_HASH * chance);
}

// The strokes of a line along one axis and of one length: their width here, as a share of the room, and their offset from the line, in
// distances between lines. place: in lengths of strokes. hash, turn, ofLine: of the line.
vec2 strokeOn(
  const in Pen pen, const in float born, const in float place, const in float hash, const in float turn, const in uint ofLine
) {
  float along = place + hash;
  // Strokes start late by chance, and so differ in length: otherwise the ends of neighbours would lie in rows across the lines.
  float stroke = floor(along);
  if (along < stroke + latenessOf(strokeHash01(ofLine, stroke))) stroke -= 1.0;
  float chance = strokeHash01(ofLine, stroke);
  float late = latenessOf(chance);
  float size = 1.0 + latenessOf(strokeHash01(ofLine, stroke + 1.0)) - late;
  float way = 2.0 * (along - stroke - late) / size - 1.0; // from −1 at one end to 1 at the other
  // Properties of strokes are spread evenly over a surface. The first strokes to appear lie on one of three neighbouring lines.
  float even = strokeHash01(uint(hash * 16777216.0) << 8u, stroke);
  float there = clamp((pen.tone - pen.allFrom * fract(turn + even / 3.0)) / STROKE_GROWTH, 0.0, 1.0);
  float gap = fract(GAP_HASH * even);
  float inside = 1.0 - abs(way) - pen.open * STROKE_GAP * gap - SHORTENING * (1.0 - there);
  float taper = pen.open * TAPER;
  float rest = clamp((taper - inside) / max(taper, 1e-3), 0.0, 1.0);
  there *= clamp((born - fract(BIRTH_HASH * even)) / BIRTH, 0.0, 1.0);
  float spread = 1.0 + irregularity * WIDTH_SPREAD * pen.open * (fract(WIDTH_HASH * even) - 0.5);
  float astray = LEANING * (gap - 0.5) * way + BENDING * (chance - 0.5) * (0.5 - way * way);
  return vec2(pen.width * there * spread * (1.0 - rest * rest), irregularity * pen.open * astray);
}

// The share of the first axis on a line: lines change from one axis to the other one by one.
float firstOnLine(const in Along along, const in float hash) {
  return clamp(((1.0 + AXIS_TURN) * along.share - fract(AXIS_HASH * hash)) / AXIS_TURN, 0.0, 1.0);
}

// Most fragments lie along one axis and at one length of strokes; others blend two of each. This is a loop, not four calls: as its number
// of passes is not constant, no compiler unrolls it or those around it.
vec2 strokesOn(const in Pen pen, const in float born, const in float line) {
  Along along = pen.along;
  float number = numberOf(line, pen.family);
  float hash = hash01(abs(number));
  float turn = turnOf(abs(number));
  uint ofLine = bitsOfLine(abs(number));
  float first = firstOnLine(along, hash);
  bool isFirst = first >= 0.5;
  float other = min(first, 1.0 - first);
  int lengths = along.longer > 0.0 ? 2 : 1;
  int ways = other > 0.0 ? 2 * lengths : lengths;
  vec2 strokes = vec2(0.0);
  for (int i = 0; i < ways; i++) {
    bool isOther = i >= lengths;
    bool isLonger = i == 1 ? !isOther : i == 3;
    float share = (isOther ? other : 1.0 - other) * (isLonger ? along.longer : 1.0 - along.longer);
    float place = isFirst == isOther ? along.places.y : along.places.x;
    strokes += share * strokeOn(pen, born, place / (isLonger ? 2.0 * along.period : along.period), hash, turn, ofLine);
  }
  return vec2(strokes.x, sign(number) * strokes.y);
}

// How many strokes of a line there are, and how thin. share: of the room of old lines that the line has. New strokes are fewer and thinner at
// once: at full width they would fill the room between the old ones. In the darks they are only thinner, since a missing stroke would be a
// hole.
float thereOn(const in Pen pen, const in float share) {
  return mix(1.0, sqrt(max(share, 0.0)), sqrt(pen.open));
}

// away: signed distance from the line, pixels, as are half of the line's room and the spacing of old lines. there: see thereOn.
float penCoverage(
  const in Pen pen, const in float away, const in float room, const in float there, const in float spacing, const in float line
) {
  float whole = room / max(there, 1e-4);
  // Most pixels are touched by one line at most.
  if (abs(away) >= max(whole * pen.widest, 0.5) + FRINGE + spacing * pen.strays) return 0.0;
  vec2 stroke = strokesOn(pen, bornBelow(there), line);
  return lineCoverage(abs(away - spacing * stroke.y), whole * stroke.x, FRINGE);
}
