#include "noNeighbours"

vec2 frameUv(const in HatchingParameters h) {
  vec3 axis = firstField(h.toLight, h.bend).axis;
  return vec2(dot(h.point, across(axis)), dot(h.point, axis));
}
