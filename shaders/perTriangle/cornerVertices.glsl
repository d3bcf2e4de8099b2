// The layout `corner`: vertices are attributes, declared by src/mesh/bake/attributeLayouts.ts.
#include "cornerAttributes"

AdjacencyPrimitive readDrawnPrimitive() {
  int corner = int(cornerNext.w + 0.5);
  // The others are stored relative to this corner. Undoing that gives all three corners of the triangle the same operands in the same
  // order, hence bit-identical frames, and only values that differ by corner are interpolated.
  vec3 next = cornerNext.xyz;
  vec3 v0 = corner == 0 ? position : corner == 1 ? cornerPrevious : next;
  vec3 v1 = corner == 1 ? position : corner == 2 ? cornerPrevious : next;
  vec3 v2 = corner == 2 ? position : corner == 0 ? cornerPrevious : next;
  return AdjacencyPrimitive(corner, v0, v1, v2, oppositeAlpha, oppositeBeta, oppositeGamma);
}

// This layout knows the rest pose only, however three.js deforms the vertex.
vec3 readDrawnPosition(const in vec3 deformed) {
  return position;
}
