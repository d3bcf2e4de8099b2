// Declarations for `triangle` and `adjacency`: lights, the triangle and its neighbours.
#include <lights_pars_begin>
#include "lightOrientation"
#include "perTriangle/triangleGeometry"
#include "perTriangle/adjacencyPrimitive"
#include "perTriangle/vertexLayouts"
#include "perTriangle/strokeCoordinates"
#include "safeNormalize"
