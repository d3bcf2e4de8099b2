// Engraved lines: level sets of a function on the object. They never break, fork or repeat, on any mesh. They swell with the tone, new
// lines appear between old ones as the camera comes nearer, and other families cross them in the darks.
uniform float crossFrom; // tone above which lines cross
uniform vec4 layerTurns; // cosine and sine of the angle between a family and the next, and of half of the supplement of that angle
uniform float screenSpaceShare; // 0: lines spaced on the object, 1: on the screen
uniform float lineContrast; // 1: lines; 0: an even grey of the same tone

#include "technique/ruledLines"

// The darkness of three families printed over one another. first: tone of the first. crossing: tone of the other two together. lean: cosine
// and sine of the angle at which they cross it.
float families(const in HatchingParameters h, const in float first, const in float crossing, const in vec2 lean) {
  // One of the two families that lean back is left out where the first has no lines, since both would coincide.
  float shareB = lean.y < 0.0 ? h.shareB + h.firstShare - 1.0 : h.shareB;
  float blankB = mix(1.0, 1.0 - crossing, shareB);
  float blankC = (1.0 - crossing) / max(blankB, 1e-4);
  // Families without ink are skipped: the one that takes more comes first.
  bool isB = shareB >= 0.5;
  float second = 1.0 - (isB ? blankB : blankC);
  float third = 1.0 - (isB ? blankC : blankB);
  int count = third > LEAST_TONE ? 3 : second > LEAST_TONE ? 2 : 1;
  float blank = 1.0;
  for (int i = first > 0.0 ? 0 : 1; i < count; i++) {
    Family family = firstFamily(h);
    if (i > 0) family = crossingFamily(h, (i == 1) == isB, lean);
    float tone = handTone(h.pressure, i == 0 ? first : i == 1 ? second : third);
    blank *= 1.0 - ruledLines(h, family, tone);
  }
  return 1.0 - blank;
}

// All families together leave as much blank as the tone does, Π (1 − Tᵢ).
float hatchLayer(const in HatchingParameters h, const in float tone) {
  float first = h.firstShare * takenOf(tone, crossFrom);
  float others = leftOf(tone, first);
  #if TECHNIQUE == TECHNIQUE_PEN
    // Two families cross at a slant and would leave rows of rhombs open in the darks: the third leans back.
    float second = takenOf(others, THIRD_FROM);
    float third = leftOf(others, second);
    float blank = 1.0;
    int passes = third > LEAST_TONE ? 2 : 1;
    for (int i = 0; i < passes; i++) {
      bool isOther = i == 1;
      vec2 lean = isOther ? -layerTurns.zw : layerTurns.xy;
      blank *= 1.0 - families(h, isOther ? 0.0 : first, isOther ? third : second, lean);
    }
    float darkness = 1.0 - blank;
  #else
    float darkness = families(h, first, others, layerTurns.xy);
  #endif // TECHNIQUE
  return tone >= 1.0 ? 1.0 : mix(tone, darkness, lineContrast);
}
