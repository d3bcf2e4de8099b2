#include "noNeighbours"

vec2 frameUv(const in HatchingParameters h) {
  return tilesPerObjectUnit * vec2(dot(h.point, h.uAxis), dot(h.point, h.vAxis));
}
