#include "perTriangle/crossedUv"

float crossingOf(const in HatchingParameters h) {
  return vCrossing;
}

HatchingParameters secondLayer(const in HatchingParameters h) {
  return HatchingParameters(crossedUv(h.uv));
}
