// Engraved lines: level sets of a function on the object. They never break, fork or repeat, on any mesh. They swell with the tone, new
// lines appear between old ones as the camera comes nearer, and other families cross them in the darks.
uniform float crossFrom; // tone above which lines cross
uniform vec4 layerTurns; // cosine and sine of the angle between a family and the next, and of half of the supplement of that angle
uniform float screenSpaceShare; // 0: lines spaced on the object, 1: on the screen
uniform float lineContrast; // 1: lines; 0: an even grey of the same tone

#include "technique/ruledLines"

// Strokes of a hand take two tones at once.
#ifndef Tones
  #define Tones float
#endif // Tones

// The darkness of three families printed over one another. first: tone of the first. crossing: tone of the other two together. lean: cosine
// and sine of the angle at which they cross it.
float families(const in HatchingParameters h, const in Tones first, const in Tones crossing, const in vec2 lean) {
  // One of the two families that lean back is left out where the first has no lines, since both would coincide.
  float shareB = lean.y < 0.0 ? h.shareB + h.firstShare - 1.0 : h.shareB;
  Tones blankB = 1.0 - shareB * crossing;
  Tones blankC = (1.0 - crossing) / max(blankB, 1e-4);
  // Families without ink are skipped: the one that takes more comes first.
  bool isB = shareB >= 0.5;
  Tones second = 1.0 - (isB ? blankB : blankC);
  Tones third = 1.0 - (isB ? blankC : blankB);
  int count = dot(third, Tones(1.0)) > LEAST_TONE ? 3 : dot(second, Tones(1.0)) > LEAST_TONE ? 2 : 1;
  float blank = 1.0;
  for (int i = dot(first, Tones(1.0)) > 0.0 ? 0 : 1; i < count; i++) {
    Family family = firstFamily(h);
    if (i > 0) family = crossingFamily(h, (i == 1) == isB, lean);
    Tones tone = handTone(h.pressure, i == 0 ? first : i == 1 ? second : third);
    blank *= 1.0 - ruledLines(h, family, tone);
  }
  return 1.0 - blank;
}

// Fades lines into an even grey of their tone where they would shimmer.
float contrasted(const in float tone, const in float darkness) {
  return tone >= 1.0 ? 1.0 : mix(tone, darkness, lineContrast);
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
    int passes = dot(third, Tones(1.0)) > LEAST_TONE ? 2 : 1;
    for (int i = 0; i < passes; i++) {
      bool isOther = i == 1;
      vec2 lean = isOther ? -layerTurns.zw : layerTurns.xy;
      blank *= 1.0 - families(h, isOther ? Tones(0.0) : first, isOther ? third : second, lean);
    }
    float darkness = 1.0 - blank;
  #else
    float darkness = families(h, first, others, layerTurns.xy);
  #endif // TECHNIQUE
  return contrasted(tone, darkness);
}
