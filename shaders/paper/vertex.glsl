// What `triangle` and `adjacency` need to know of the lights, the triangle and its neighbours.
#include <lights_pars_begin>
#include "lightOrientation"
#include "paper/triangleGeometry"
#include "paper/adjacencyPrimitive"
#include "paper/vertexLayouts"
#include "paper/strokeCoordinates"
