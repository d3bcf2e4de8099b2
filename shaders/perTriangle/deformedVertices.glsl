// The layout `pull` of a mesh that deforms, as written by the deformation pass.
#include "perTriangle/pullPrimitive"

uniform highp sampler2D deformedPositions;
uniform highp sampler2D deformedNormals;
uniform highp sampler2D deformedTurns;

AdjacencyPrimitive readDrawnPrimitive() {
  return pullPrimitive(deformedPositions);
}

vec3 readDrawnPosition(const in vec3 deformed) {
  return deformed;
}
