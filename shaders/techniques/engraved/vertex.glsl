#include <lights_pars_begin>
#include "perFragment/vertex"
#include "technique/lightField"
