#include "technique/hatchLayer"

#if STROKE_LAYERS == 2
  // What shifts the second layer's pattern against the first's, in tiles or, for `anchored`, in anchors.
  #define LAYER_SHIFT vec3(17.37, 5.71, 11.13)
  #include "technique/secondLayer"

  // The darkness of the hatch. A second layer takes over as much of the tone as the lights disagree, so that one printed
  // over the other, 1 − (1 − T₁)(1 − T₂), they give the tone again.
  float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
    // Where nothing stays blank, any share of the tone would fill both layers.
    PerToneNormal blank = max(1.0 - tone, 1e-3);
    float share = 0.5 * crossingOf(h);
    float first = hatchLayer(h, 1.0 - pow(blank, PerToneNormal(1.0 - share)));
    float second = hatchLayer(secondLayer(h), 1.0 - pow(blank, PerToneNormal(share)));
    return 1.0 - (1.0 - first) * (1.0 - second);
  }
#else
  float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
    return hatchLayer(h, tone);
  }
#endif // STROKE_LAYERS
