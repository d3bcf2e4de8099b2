#include "crossedTones"
#include "technique/hatchLayer"
#include "technique/layers"

// The darkness of the hatch: of its layers, printed over one another.
#if LAYERS_BY_LIGHTS
  // A second layer along the other axis of the tensor takes over as much of the tone as the lights disagree, so that 1 − (1 − T₁)(1 − T₂)
  // is the tone again.
  float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
    // At full tone any share would fill both layers.
    PerToneNormal blank = max(1.0 - tone, 1e-3);
    float share = 0.5 * crossingOf(h);
    float first = hatchLayer(h, 1.0 - pow(blank, PerToneNormal(1.0 - share)));
    float second = hatchLayer(turnedLayer(h, 1.0, vec2(0.0, 1.0)), 1.0 - pow(blank, PerToneNormal(share)));
    return 1.0 - (1.0 - first) * (1.0 - second);
  }
#elif STROKE_LAYERS == STROKE_LAYERS_TONE
  uniform float crossFrom; // tone above which a second layer crosses the first
  uniform vec4 layerTurns; // cosine and sine of the angle from the first layer to the second, and to the third

  float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
    PerToneNormal first = takenOf(tone, crossFrom);
    PerToneNormal others = leftOf(tone, first);
    PerToneNormal second = takenOf(others, THIRD_FROM);
    PerToneNormal third = leftOf(others, second);
    return 1.0 - (1.0 - hatchLayer(h, first))
      * (1.0 - hatchLayer(turnedLayer(h, 1.0, layerTurns.xy), second))
      * (1.0 - hatchLayer(turnedLayer(h, 2.0, layerTurns.zw), third));
  }
#else
  float hatch(const in HatchingParameters h, const in PerToneNormal tone) {
    return hatchLayer(h, tone);
  }
#endif // LAYERS_BY_LIGHTS
