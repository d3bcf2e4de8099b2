#include "noNeighbours"

vec2 frameUv(const in HatchingParameters h) {
  return fieldUv(h);
}
