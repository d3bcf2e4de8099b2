#include "perFragment/vertex"
