#include "noNeighbours"

vec2 frameUv(const in HatchingParameters h) {
  return vec2(dot(h.point, h.sideB), h.value);
}
