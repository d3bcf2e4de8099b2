#include "noNeighbours"

vec2 frameUv(const in HatchingParameters h) {
  vec3 axis = fieldAxis(h.toLight);
  return strokeScale * vec2(dot(h.point, across(axis)), dot(h.point, axis));
}
