// Whole strokes of a hand. The level sets of a function are rows, another function tells the place along a row, and a row is divided into
// cells of one stroke each. A stroke is stored as its offset from the row and its width at steady steps along it.
#include "lineCoverage"
#include "technique/lineSpacing"
#include "technique/strokeLengths"
#include "technique/strokeHashes"

#ifdef SHADOWS_ALONG_STROKES
  // A tone without the shadows that are read along strokes, and that in all of them.
  #define Tones vec2
  #define litOf(tones) tones.x

  // Both of these tones of a surface.
  vec2 tonesOfShadows(const in HatchingSurface surface) {
    sumCastLight(-vViewPosition);
    vec2 here = openToLights() * castHere;
    vec2 tones;
    for (int i = 0; i < 2; i++) {
      float radiance = surface.radiance - here.y + (i == 0 ? here.x : 0.0);
      tones[i] = faded(deepened(darkenedByColor(toneFromRadiance(exposed(radiance)), surface)));
    }
    return tones;
  }

  vec2 handTone(const in float pressure, const in vec2 tones) {
    return vec2(handTone(pressure, tones.x), handTone(pressure, tones.y));
  }

  vec2 takenOf(const in vec2 tones, const in float from) {
    return vec2(takenOf(tones.x, from), takenOf(tones.y, from));
  }

  vec2 leftOf(const in vec2 tones, const in vec2 taken) {
    return vec2(leftOf(tones.x, taken.x), leftOf(tones.y, taken.y));
  }

  float contrasted(const in float tone, const in float darkness);

  float contrasted(const in vec2 tones, const in float darkness) {
    return contrasted(mix(tones.x, tones.y, castHere.x > 0.0 ? 1.0 - castHere.y / castHere.x : 0.0), darkness);
  }

  float hatchLayer(const in HatchingParameters h, const in vec2 tones);

  float hatchLayer(const in HatchingParameters h, const in float tone) {
    return hatchLayer(h, vec2(tone));
  }
#else
  #define Tones float
  #define litOf(tones) tones
#endif // SHADOWS_ALONG_STROKES

// Each stroke: its offset across the row, and half of its width, in distances between rows. The last rows of the texture say how tones are
// drawn: the share of strokes that are there, and what is added to their half widths.
uniform sampler2D handStrokes;
uniform vec4 handReach; // number of strokes, greatest offset and half width, and the share of a cell that the longest stroke fills
// How much shorter strokes may be than the longest, and by how much of their distance rows are drawn together to bundles, as shares.
uniform vec2 handRows;
// Of a row whose strokes lie in two lanes: how far each lane lies to its side of the row, in distances between rows, and how far the cells of
// the second are shifted, in cells. 0 for rows of one lane.
uniform vec2 handLanes;

// The cells of a family's rows.
struct Cells {
  vec2 places; // two coordinates along the rows, in tiles
  #ifdef SHADOWS_ALONG_STROKES
    // Steps on the surface, in view space: along a row while each of the places grows by 1, and straight across rows while the family's
    // function does.
    mat2x3 steps;
    vec3 stepAcross;
    vec3 normal;
  #endif // SHADOWS_ALONG_STROKES
  float share; // of the first coordinate
  float repeat; // places after which cells repeat across a seam of the bake
  float period; // length of a cell
  float paired; // share of the pairs of cells that hold one stroke together
  float longest; // part of such a pair that its stroke may fill
  float perPixel; // change of the places from one pixel to the next, on a surface that faces the viewer
  vec2 perPixelOfRow; // change of the places from one pixel to the next along a row, on the screen
  vec2 askew; // change of the places, straight across a row on the screen, while the family's function grows by 1
};

bool isFirst(const in HatchingParameters h, const in Family family) {
  #ifdef FOLLOWS_FORM
    return family.value == h.values.x;
  #else
    return family.value == h.value;
  #endif // FOLLOWS_FORM
}

#ifdef SHADOWS_ALONG_STROKES
  // The Jacobian of the map from pixels to the tangent plane in view space. normal: view space, of any length.
  mat2x3 tangentOnScreen(const in vec3 normal) {
    vec2 centre = centreOfScreen();
    float facing = abs(dot(normal, vec3(centre, 1.0)));
    return screenMapOf(normal * (vViewUnitsPerPixel / max(facing, LEAST_FACING * length(normal))), centre, mat3(1.0));
  }

  // The view-space step along a row while a place grows by 1. change: of the place, on the screen. ofRow: the way of the row on the screen.
  vec3 stepOf(const in mat2x3 inView, const in vec2 change, const in vec2 ofRow, const in float least) {
    float perPixel = dot(change, ofRow);
    return inView * ofRow * ((perPixel < 0.0 ? -1.0 : 1.0) / max(abs(perPixel), least));
  }
#endif // SHADOWS_ALONG_STROKES

Cells cellsFor(const in HatchingParameters h, const in Family family) {
  Cells cells;
  // The length of a stroke does not depend on the slant at which it is seen, so that no stroke is cut where the form turns away.
  float tilesPerPixel = vViewUnitsPerPixel * length((objectToField * readViewToAnchor())[0]);
  #ifdef FOLLOWS_FORM
    bool alongCrossing = isFirst(h, family);
    float rise = alongCrossing ? h.rises.y : h.rises.x;
    cells.places = vec2(alongCrossing ? h.values.y : h.values.x);
    cells.share = 1.0;
    cells.repeat = powerOf2(alongCrossing ? h.coarsest.y : h.coarsest.x);
    vec2 first = alongCrossing ? h.crossingOnScreen : h.valueOnScreen;
    vec2 second = first;
  #else
    float rise = AXIS_RISE;
    Along along = alongLines(h, family);
    cells.places = along.places;
    cells.share = along.share;
    cells.repeat = ROW_SHIFT;
    vec2 first = screenGradient(along.first, h.onScreen);
    vec2 second = screenGradient(along.second, h.onScreen);
  #endif // FOLLOWS_FORM
  cells.perPixel = max(tilesPerPixel * rise, 1e-12);
  vec2 across = screenGradient(family.gradient, h.onScreen);
  across /= max(length(across), 1e-12);
  cells.perPixelOfRow = max(vec2(crossed(first, across), crossed(second, across)), 0.1 * cells.perPixel);
  cells.askew = vec2(dot(first, across), dot(second, across)) / max(family.perPixel, 1e-12);
  #ifdef SHADOWS_ALONG_STROKES
    cells.normal = safeNormalize(vFieldNormal) * (objectToField * readViewToAnchor());
    mat2x3 inView = tangentOnScreen(cells.normal);
    vec2 ofRow = vec2(-across.y, across.x);
    cells.steps[0] = stepOf(inView, first, ofRow, 0.1 * cells.perPixel);
    cells.steps[1] = stepOf(inView, second, ofRow, 0.1 * cells.perPixel);
    cells.stepAcross = inView * across / max(family.perPixel, 1e-12);
    cells.normal = safeNormalize(cells.normal);
  #endif // SHADOWS_ALONG_STROKES
  float octave = mix(octaves(strokeLength / PARTS_OF_TILE * rise), octaves(strokeLength * cells.perPixel), screenSpaceShare);
  cells.period = powerOf2(floor(octave));
  // Strokes of one cell and of two have the wanted length in the mean.
  float wanted = clamp(powerOf2(octave) / cells.period, 1.0, 2.0);
  // Strokes of two lanes fill their cells evenly.
  float most = handLanes.x > 0.0 ? 2.0 : min(LONGEST_IN_PAIR * wanted, 2.0);
  cells.paired = 2.0 * (wanted - 1.0) / (most + wanted - 2.0);
  cells.longest = 0.5 * most;
  return cells;
}

// The rank below which strokes are there if a given share of them is, and the range over which they grow: few strokes are whole too.
vec2 bornBelow(const in float share) {
  float few = share / (1.0 - 0.5 * GROWING);
  if (few * GROWING < GROWTH) return vec2(few, max(few * GROWING, 1e-6));
  float most = share + 0.5 * GROWTH;
  return vec2(most <= 1.0 ? most : 1.0 + GROWTH - sqrt(max(2.0 * GROWTH * (1.0 - share), 0.0)), GROWTH);
}

// A row as a pixel sees it.
struct Row {
  float number; // among the old rows; young ones lie half way between two
  float apart; // distance of old rows, in mean distances
  float away; // signed distance from it, in distances between rows
  float way; // −1 where rows are numbered, and run, the other way
  float turn;
  uint bits, evenBits; // random, and spread evenly over neighbouring rows
  uint ofLane; // differing bits of the second lane
  float late; // by which its cells begin later, in cells
  vec2 born; // rank below which its strokes are there, and the range of ranks over which they grow
  float widening; // what is added to half widths
  #ifdef SHADOWS_ALONG_STROKES
    vec2 bornInShadow;
    float wideningInShadow;
    vec3 middle; // its nearest point, view space
  #endif // SHADOWS_ALONG_STROKES
};

// The number of a cell among those of a row that differ: the same on both sides of a seam, unless a cell is longer than what the seam
// repeats after.
float numberOfCell(const in float cell, const in float repeat) {
  #ifdef FOLLOWS_FORM
    return repeat > 1.0 ? cell - repeat * floor(cell / repeat) : cell;
  #else
    return cell;
  #endif // FOLLOWS_FORM
}

// The number of a row within its bundle, 0 for the middle one. Whole rows lie far from where mod, which is inexact, jumps.
float fromMiddle(const in float row) {
  return mod(row + 0.5 * BUNDLED_ROWS, BUNDLED_ROWS) - 0.5 * BUNDLED_ROWS;
}

// How far a stroke lies aside of its row, in mean distances. lot: of the bundles of its row, from 0 to BUNDLED_ROWS − 1.
float bundledAside(const in Row row, const in float lot) {
  float ofAll = 0.5 * fromMiddle(2.0 * row.number + lot);
  float drawn = fract(row.number) == 0.0 ? mix(fromMiddle(row.number + lot), ofAll, row.apart - 1.0) : ofAll;
  return -handRows.y * row.apart * drawn;
}

float grownAt(const in vec2 born, const in float rank) {
  return clamp((born.x - rank) / born.y, 0.0, 1.0);
}

// The share of a pixel that the strokes of a row cover, counted along the first or the second place. spacing: pixels.
float strokeCoverage(const in Row row, const in Cells cells, const in vec2 places, const in int which, const in float isDark, const in float spacing) {
  float place = places[which];
  float share = which == 0 ? cells.share : 1.0 - cells.share;
  // Rows are shifted by chance: any rule would show where their strokes end.
  float x = (row.way * place + strokeHash01(row.bits, 0.0) * cells.repeat) / cells.period - row.late;
  float most = cells.repeat / cells.period;
  float pair = floor(0.5 * x);
  // Each pair of strokes gives way to one twice as long at a moment of its own.
  float moment = strokeHash01(row.bits ^ SECOND_FACTOR, numberOfCell(pair, 0.5 * most));
  float turned = (cells.paired * (1.0 + PAIR_TURN) - moment) / PAIR_TURN;
  bool isPair = turned > 0.5;
  float there = clamp(isPair ? 2.0 * turned - 1.0 : 1.0 - 2.0 * turned, 0.0, 1.0);
  float cell = isPair ? pair : floor(x);
  float inCell = isPair ? 0.5 * x - pair : x - cell;
  float number = numberOfCell(cell, isPair ? 0.5 * most : most);
  // Ranks are spread evenly over a surface: the first strokes lie on one of three neighbouring rows.
  float rank = fract(row.turn + strokeHash01(row.evenBits ^ row.ofLane, number) / 3.0);
  float grown = grownAt(row.born, rank);
  #ifdef SHADOWS_ALONG_STROKES
    float inShadow = grownAt(row.bornInShadow, rank);
    if (!(max(grown, inShadow) > 0.0)) return 0.0;
  #else
    if (!(grown > 0.0)) return 0.0;
  #endif // SHADOWS_ALONG_STROKES
  float chance = strokeHash01(row.bits ^ row.ofLane, number);
  there = min(there, ((1.0 + AXIS_TURN) * share - fract(AXIS_HASH * chance)) / AXIS_TURN);
  if (!(there > 0.0)) return 0.0;
  float size = handReach.w * (1.0 - handRows.x * fract(SIZE_HASH * chance)) * (isPair ? cells.longest : 1.0);
  float start = mix(fract(START_HASH * chance), 0.5, handLanes.x > 0.0 ? LANE_STEADINESS : 0.0);
  float t = (inCell - (1.0 - size) * start) / size;
  if (!(t > 0.0 && t < 1.0)) return 0.0;
  float aside = row.way * row.away;
  if (handRows.y > 0.0) {
    // Strokes side by side are of one bundle, and others farther along: no gap runs all along the rows.
    float repeat = isPair ? 0.5 * most : most;
    float place = floor((cell + 0.5 - strokeHash01(row.bits, 0.0) * repeat) / BUNDLE_CELLS);
    float lot = floor(BUNDLED_ROWS * strokeHash01(SECOND_FACTOR, numberOfCell(place, repeat / BUNDLE_CELLS)));
    aside -= bundledAside(row, lot);
  }
  float widening = row.widening;
  float cellLength = (isPair ? 2.0 : 1.0) * cells.period;
  float left = 1.0; // of the half that the pixel sees
  #ifdef SHADOWS_ALONG_STROKES
    float widest = handReach.y + handReach.z + max(widening, row.wideningInShadow);
    if (spacing * (abs(aside) - widest) > FRINGE) return 0.0;
    if (grown != inShadow || widening != row.wideningInShadow) {
      vec3 step = row.way * size * cellLength * cells.steps[which];
      // The shadows at its middle, and at the middle of the third at this end.
      vec2 shadows;
      for (int i = 0; i < 2; i++) {
        float at = i == 0 ? 0.5 : t < 0.5 ? 1.0 / 6.0 : 5.0 / 6.0;
        shadows[i] = shadowAt(row.middle + (at - t) * step, cells.normal);
        // A stroke is there as far as its middle is.
        if (i == 0 && !(mix(grown, inShadow, shadows.x) > 0.0)) return 0.0;
      }
      vec2 parts = mix(vec2(grown), vec2(inShadow), shadows);
      grown = parts.x;
      // An end that is not there loses a sixth of the stroke, so that what is left is no fleck.
      left = 1.0 - max(1.0 - parts.y / grown, 0.0) / 3.0;
      widening = mix(widening, row.wideningInShadow, shadows.x);
    }
  #endif // SHADOWS_ALONG_STROKES
  there = min(there, grown);
  if (!(there > 0.0)) return 0.0;
  // A stroke that is not there in full is shorter, and ends as the hand ends it.
  t = 0.5 + (t - 0.5) / (there * left);
  if (!(t > 0.0 && t < 1.0)) return 0.0;
  float chosen = mix(0.5 * isDark, 1.0, rank) * (1.0 - SHAPES_OF_RANK) + SHAPES_OF_RANK * fract(SHAPE_HASH * chance);
  float shape = min(floor(handReach.x * chosen), handReach.x - 1.0);
  vec2 stroke = textureLod(handStrokes, vec2((t * (PLACES - 1.0) + 0.5) / PLACES, (shape + 0.5) / HAND_ROWS), 0.0).rg;
  float fromEnd = min(t, 1.0 - t);
  float halfWidth = (stroke.g + widening * min(1.0, WIDENED_ENDS * fromEnd)) * min(1.0, there / WIDE_FROM);
  halfWidth *= spacing;
  // Blunt ends are round, as the tip of a pen leaves them.
  float toEnd = fromEnd * there * left * size * cellLength / cells.perPixelOfRow[which];
  float cap = max(1.0 - toEnd / max(halfWidth, 0.5), 0.0);
  return lineCoverage(spacing * abs(aside - stroke.r), halfWidth * sqrt(1.0 - cap * cap), FRINGE);
}

// How a family draws a tone.
struct Drawn {
  // Of old and of young rows: the rank below which strokes are there, and the range of ranks over which they grow.
  vec2 bornOld, bornYoung;
  float widening; // what is added to half widths
};

// The tone that rows have whose strokes fill their cells as the hand's do, where those that fill less of them have a given tone. A row
// darkens by as much as it fills less, and where rows overlap each lets through what the others leave.
float filledTone(const in float tone, const in float filled) {
  float ofCells = COVERED_OF_FILLED * handReach.w * (1.0 - 0.5 * handRows.x);
  float left = ofCells * filled;
  return tone < left ? tone / filled : 1.0 - pow(1.0 - tone, log2(1.0 - ofCells) / log2(1.0 - left));
}

// filled: how much of the share of their cells that the hand's strokes fill is filled. young: the share of the strokes of young rows.
Drawn drawnAs(const in float tone, const in float filled, const in float young) {
  float wanted = filledTone(clamp(tone, 0.0, 1.0), filled);
  vec2 at = vec2(wanted * (PLACES - 1.0) + 0.5, HAND_ROWS - TONE_ROWS + 0.5 + young * (TONE_ROWS - 1.0));
  vec2 drawn = textureLod(handStrokes, at / vec2(PLACES, HAND_ROWS), 0.0).rg;
  return Drawn(bornBelow(drawn.x), bornBelow(young * drawn.x), drawn.y);
}

// The darkness of a family.
float ruledLines(const in HatchingParameters h, const in Family family, const in Tones tone) {
  float trianglePerPixel = trianglePerPixelOf(family);
  float octave = min(octaveOf(family, trianglePerPixel), family.coarsest);
  float period = powerOf2(ceil(octave));
  float spacing = powerOf2(octave) / trianglePerPixel; // mean distance of rows, pixels
  float apart = period / powerOf2(octave); // distance of old rows, in mean distances
  // Of the young rows, half way between the old ones, as many strokes are there as keep the mean distance.
  float young = clamp(apart - 1.0, 0.0, 1.0);
  Cells cells = cellsFor(h, family);
  // Strokes fill less of their cells where pairs have given way to one: as if the tone were darker.
  float filled = (1.0 - cells.paired * (1.0 - cells.longest)) * (1.0 - 0.5 * PAIR_TURN);
  Drawn drawn = drawnAs(litOf(tone), filled, young);
  float widest = drawn.widening;
  bool isYoungThere = drawn.bornYoung.x > 0.0;
  #ifdef SHADOWS_ALONG_STROKES
    Drawn inShadow = drawnAs(tone.y, filled, young);
    widest = max(widest, inShadow.widening);
    isYoungThere = isYoungThere || inShadow.bornYoung.x > 0.0;
  #endif // SHADOWS_ALONG_STROKES
  float isDark = isFirst(h, family) ? 0.0 : 1.0;
  float x = family.value / period;
  int lanes = handLanes.x > 0.0 ? 1 : 0; // beside the first
  float reach = (handReach.y + handReach.z + widest + FRINGE / spacing) / apart;
  float first = ceil(2.0 * (x - reach));
  float blank = 1.0;
  for (int i = 0; i < 2 * MOST_ROWS; i++) {
    float line = 0.5 * (first + float(i >> lanes));
    if (!(line <= x + reach)) break;
    bool isYoung = fract(line) != 0.0;
    if (isYoung && !isYoungThere) continue;
    float number = numberOf(line * period, family);
    #ifdef FOLLOWS_FORM
      float way = number < 0.0 ? -1.0 : 1.0;
    #else
      float way = 1.0;
    #endif // FOLLOWS_FORM
    number = abs(number) == 0.0 ? 0.0 : way * number;
    Row row;
    row.turn = turnOf(number);
    row.born = isYoung ? drawn.bornYoung : drawn.bornOld;
    float born = row.born.x;
    #ifdef SHADOWS_ALONG_STROKES
      row.bornInShadow = isYoung ? inShadow.bornYoung : inShadow.bornOld;
      born = max(born, row.bornInShadow.x);
    #endif // SHADOWS_ALONG_STROKES
    // The ranks of a row begin at its turn, unless some of them lie beyond 1.
    if (row.turn >= born && row.turn <= 2.0 / 3.0) continue;
    row.number = number / period;
    row.apart = apart;
    bool isSecond = (i & lanes) > 0;
    row.away = (x - line) * apart + (isSecond ? -way : way) * handLanes.x;
    row.way = way;
    row.evenBits = lineBits(THUE_MORSE, number) & 0xffffff00u;
    row.bits = bitsOfLine(number);
    row.ofLane = isSecond ? THIRD_FACTOR : 0u;
    row.late = isSecond ? handLanes.y : 0.0;
    row.widening = drawn.widening;
    #ifdef SHADOWS_ALONG_STROKES
      row.wideningInShadow = inShadow.widening;
      row.middle = -vViewPosition - cells.stepAcross * ((x - line) * period);
    #endif // SHADOWS_ALONG_STROKES
    // The places of the nearest point of the row: strokes end straight across their rows.
    vec2 places = cells.places - cells.askew * ((x - line) * period);
    blank *= 1.0 - strokeCoverage(row, cells, places, 0, isDark, spacing);
    #ifndef FOLLOWS_FORM
      if (cells.share < 1.0) blank *= 1.0 - strokeCoverage(row, cells, places, 1, isDark, spacing);
    #endif // FOLLOWS_FORM
    if (!(blank > 0.0)) break;
  }
  return 1.0 - blank;
}
