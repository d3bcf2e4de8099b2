#include "perTriangle/turnedUv"

#if LAYERS_BY_LIGHTS
  float crossingOf(const in HatchingParameters h) {
    return vCrossing;
  }
#endif // LAYERS_BY_LIGHTS

HatchingParameters turnedLayer(const in HatchingParameters h, const in float layer, const in vec2 turn) {
  return HatchingParameters(turnedUv(h.uv, layer, turn));
}
