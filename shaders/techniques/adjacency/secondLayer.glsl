#include "perTriangle/crossedUv"

float crossingOf(const in HatchingParameters h) {
  return blend(h, vCrossing);
}

HatchingParameters secondLayer(const in HatchingParameters h) {
  HatchingParameters second = h;
  for (int i = 0; i < 4; i++) second.uv[i] = crossedUv(h.uv[i]);
  return second;
}
