#include <lights_pars_begin>
#include "perFragment/vertex"
#include "technique/lightField"

uniform vec3 fieldOrigin; // object space
uniform mat3 objectToField; // linear part
uniform mat3 objectToFieldNormal; // its inverse transpose
