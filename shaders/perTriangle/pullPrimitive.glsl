#include "perTriangle/pulledVertices"

AdjacencyPrimitive pullPrimitive(const in highp sampler2D positions) {
  uvec4 own = ownVertices(gl_VertexID / 3);
  uvec4 opposite = oppositeVertices(gl_VertexID / 3);
  return AdjacencyPrimitive(
    gl_VertexID % 3,
    pullVertex(positions, own.x), pullVertex(positions, own.y), pullVertex(positions, own.z),
    pullVertex(positions, opposite.x), pullVertex(positions, opposite.y), pullVertex(positions, opposite.z)
  );
}
