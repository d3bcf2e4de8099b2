// How layers share a tone where others cross from some tone on: printed over one another, 1 − Π (1 − Tᵢ), they give it again.

// How much of the tone above that stays with the layer below.
#define KEPT_SHARE 0.4

// What a layer takes of a tone that others cross from `from` on.
PerToneNormal takenOf(const in PerToneNormal tone, const in float from) {
  return min(tone, from) + KEPT_SHARE * max(tone - from, 0.0);
}

// What it leaves to the others: exactly nothing up to where they begin, and then more and more.
PerToneNormal leftOf(const in PerToneNormal tone, const in PerToneNormal taken) {
  return max(tone - taken, 0.0) / max(1.0 - taken, 1e-4);
}
