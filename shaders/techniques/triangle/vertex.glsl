#include "perTriangle/vertex"
