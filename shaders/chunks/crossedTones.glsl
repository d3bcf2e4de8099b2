// Shares a tone among layers that cross one another from some tone on. Printed over one another, 1 − Π (1 − Tᵢ), they give the tone again.

// The share of the tone above that one which the lower layer still takes: more with a pen, whose first strokes lead.
#if MEDIUM == MEDIUM_PEN
  #define KEPT_SHARE 0.6
#else
  #define KEPT_SHARE 0.4
#endif // MEDIUM

// The tone left by the first layer from which on the third crosses the second. The tone is then half way from where it begins to 1.
#define THIRD_FROM 0.375

// The part of a tone that a layer prints itself, where others cross it from the tone `from` on.
PerToneNormal takenOf(const in PerToneNormal tone, const in float from) {
  return min(tone, from) + KEPT_SHARE * max(tone - from, 0.0);
}

// The tone that it leaves to the others: exactly 0 up to where they begin.
PerToneNormal leftOf(const in PerToneNormal tone, const in PerToneNormal taken) {
  return max(tone - taken, 0.0) / max(1.0 - taken, 1e-4);
}
