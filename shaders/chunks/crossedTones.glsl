// Shares a tone among layers that cross from some tone on. Printed over one another, 1 − Π (1 − Tᵢ), they give that tone again.

// The share of the tone above `from` that the lower layer still prints.
#if TECHNIQUE == TECHNIQUE_PEN
  #define KEPT KEPT_BY_PEN
#else
  #define KEPT KEPT_SHARE
#endif // TECHNIQUE

// The part of a tone that a layer prints itself, if other layers cross it above the tone `from`.
PerToneNormal takenOf(const in PerToneNormal tone, const in float from) {
  return min(tone, from) + KEPT * max(tone - from, 0.0);
}

// The tone that a layer leaves to the others: exactly 0 up to where they begin.
PerToneNormal leftOf(const in PerToneNormal tone, const in PerToneNormal taken) {
  return max(tone - taken, 0.0) / max(1.0 - taken, 1e-4);
}
