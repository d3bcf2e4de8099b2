#include "perTriangle/turnedUv"

#if LAYERS_BY_LIGHTS
  float crossingOf(const in HatchingParameters h) {
    return blend(h, vCrossing);
  }
#endif // LAYERS_BY_LIGHTS

HatchingParameters turnedLayer(const in HatchingParameters h, const in float layer, const in vec2 turn) {
  HatchingParameters turned = h;
  for (int i = 0; i < 4; i++) turned.uv[i] = turnedUv(h.uv[i], layer, turn);
  return turned;
}
