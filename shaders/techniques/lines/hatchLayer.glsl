// Engraved lines: level sets of a function on the object. They never break, fork or repeat, on any mesh. They swell with the tone, new
// lines appear between old ones as the camera comes nearer, and other families cross them in the darks.
uniform float crossFrom; // tone above which lines cross
uniform vec4 layerTurns; // cosine and sine of the angle between a family and the next, and of half of the supplement of that angle
uniform float screenSpaceShare; // 0: lines spaced on the object, 1: on the screen
uniform float lineContrast; // 1: lines; 0: an even grey of the same tone

#ifdef SHADOWS_ALONG_STROKES
  // A tone without the shadows that are read along strokes, and that in all of them.
  #define Tones vec2
  #define litOf(tones) tones.x
  #define darkestOf(tones) max(tones.x, tones.y)
  #define toneHere(tones) mix(tones.x, tones.y, castHere.x > 0.0 ? 1.0 - castHere.y / castHere.x : 0.0)
#else
  #define Tones float
  #define litOf(tones) tones
  #define darkestOf(tones) tones
  #define toneHere(tones) tones
#endif // SHADOWS_ALONG_STROKES

#include "technique/ruledLines"

// The darkness of three families printed over one another. first: tone of the first. crossing: tone of the other two together. lean: cosine
// and sine of the angle at which they cross it.
float families(const in HatchingParameters h, const in Tones first, const in Tones crossing, const in vec2 lean) {
  // One of the two families that lean back is left out where the first has no lines, since both would coincide.
  float shareB = lean.y < 0.0 ? h.shareB + h.firstShare - 1.0 : h.shareB;
  Tones blankB = mix(Tones(1.0), 1.0 - crossing, shareB);
  Tones blankC = (1.0 - crossing) / max(blankB, 1e-4);
  // Families without ink are skipped: the one that takes more comes first.
  bool isB = shareB >= 0.5;
  Tones second = 1.0 - (isB ? blankB : blankC);
  Tones third = 1.0 - (isB ? blankC : blankB);
  int count = darkestOf(third) > LEAST_TONE ? 3 : darkestOf(second) > LEAST_TONE ? 2 : 1;
  float blank = 1.0;
  for (int i = darkestOf(first) > 0.0 ? 0 : 1; i < count; i++) {
    Family family = firstFamily(h);
    if (i > 0) family = crossingFamily(h, (i == 1) == isB, lean);
    Tones tone = handTone(h.pressure, i == 0 ? first : i == 1 ? second : third);
    blank *= 1.0 - ruledLines(h, family, tone);
  }
  return 1.0 - blank;
}

// All families together leave as much blank as the tone does, Π (1 − Tᵢ).
float hatchLayer(const in HatchingParameters h, const in Tones tone) {
  Tones first = h.firstShare * takenOf(tone, crossFrom);
  Tones others = leftOf(tone, first);
  #if TECHNIQUE == TECHNIQUE_PEN
    // Two families cross at a slant and would leave rows of rhombs open in the darks: the third leans back.
    Tones second = takenOf(others, THIRD_FROM);
    Tones third = leftOf(others, second);
    float blank = 1.0;
    int passes = third > LEAST_TONE ? 2 : 1;
    for (int i = 0; i < passes; i++) {
      bool isOther = i == 1;
      vec2 lean = isOther ? -layerTurns.zw : layerTurns.xy;
      blank *= 1.0 - families(h, isOther ? Tones(0.0) : first, isOther ? third : second, lean);
    }
    float darkness = 1.0 - blank;
  #else
    float darkness = families(h, first, others, layerTurns.xy);
  #endif // TECHNIQUE
  float here = toneHere(tone);
  return here >= 1.0 ? 1.0 : mix(here, darkness, lineContrast);
}

#ifdef SHADOWS_ALONG_STROKES
  float hatchLayer(const in HatchingParameters h, const in float tone) {
    return hatchLayer(h, vec2(tone));
  }
#endif // SHADOWS_ALONG_STROKES
