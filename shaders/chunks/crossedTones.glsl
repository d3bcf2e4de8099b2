// Shares a tone among layers that cross one another from some tone on. Printed over one another, 1 − Π (1 − Tᵢ), they give the tone again.

// The share of the tone above that one which the lower layer still takes.
#if MEDIUM == MEDIUM_PEN
  #define KEPT KEPT_BY_PEN
#else
  #define KEPT KEPT_SHARE
#endif // MEDIUM

// The part of a tone that a layer prints itself, where others cross it from the tone `from` on.
PerToneNormal takenOf(const in PerToneNormal tone, const in float from) {
  return min(tone, from) + KEPT * max(tone - from, 0.0);
}

// The tone that it leaves to the others: exactly 0 up to where they begin.
PerToneNormal leftOf(const in PerToneNormal tone, const in PerToneNormal taken) {
  return max(tone - taken, 0.0) / max(1.0 - taken, 1e-4);
}
