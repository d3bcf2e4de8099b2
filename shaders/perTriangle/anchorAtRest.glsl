// Strokes of a mesh that deforms, fixed to its rest pose.
#include "perTriangle/turns"

AdjacencyPrimitive readAnchorPrimitive(const in AdjacencyPrimitive drawn) {
  return pullPrimitive(restPositions);
}

vec3 readAnchorPosition(const in vec3 drawn) {
  return position;
}

AdjacencyTurns readTurns() {
  uvec4 own = ownVertices(gl_VertexID / 3);
  uvec4 opposite = oppositeVertices(gl_VertexID / 3);
  vec4 v0 = pullTexel(deformedTurns, own.x);
  vec4 v1 = pullTexel(deformedTurns, own.y);
  vec4 v2 = pullTexel(deformedTurns, own.z);
  return AdjacencyTurns(
    addTurns(v0, v1, v2),
    addTurns(v1, v0, pullTexel(deformedTurns, opposite.x)),
    addTurns(v2, v1, pullTexel(deformedTurns, opposite.y)),
    addTurns(v0, v2, pullTexel(deformedTurns, opposite.z))
  );
}

vec3 anchorNormal(const in Triangle anchor, const in vec3 drawnNormal) {
  return normalOf(anchor);
}

// Maps the light that falls on the deformed triangle to the triangle at rest. If only the skin moves it, this is exactly its rotation: the
// rounding of corners turns small triangles.
mat3 viewToAnchor(const in mat3 viewToObject, const in Triangle drawn, const in Triangle anchor, const in vec4 turn) {
  mat3 drawnToAnchor = turn == vec4(0.0) ? triangleToTriangle(drawn, anchor) : turnBack(turn);
  return drawnToAnchor * viewToObject;
}
