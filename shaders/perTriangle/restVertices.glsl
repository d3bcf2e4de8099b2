// The layout `pull` at rest.
#include "perTriangle/pullPrimitive"

AdjacencyPrimitive readDrawnPrimitive() {
  return pullPrimitive(restPositions);
}

// As hatched, whatever three makes of the vertex.
vec3 readDrawnPosition(const in vec3 deformed) {
  return position;
}
