#include <lights_pars_begin>
#include "perFragment/vertex"
#ifdef FOLLOWS_FORM
  #include "technique/formAttributes"
#else
  #include "technique/lightField"
  #include "technique/fieldAxis"
#endif // FOLLOWS_FORM

uniform vec3 fieldOrigin; // object space
uniform mat3 objectToField; // linear part
uniform mat3 objectToFieldNormal; // its inverse transpose
