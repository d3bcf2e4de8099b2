#include "perFragment/emit"
// In the frame of the mesh, not that of its bones: lines would break at joints.
vFieldLight = fieldLight(viewToObject, (objectToView * vec4(fieldCentre, 1.0)).xyz);
