// The layout `pull` at rest.
#include "perTriangle/pullPrimitive"

AdjacencyPrimitive readDrawnPrimitive() {
  return pullPrimitive(restPositions);
}

// The rest pose, however three.js deforms the vertex.
vec3 readDrawnPosition(const in vec3 deformed) {
  return position;
}
