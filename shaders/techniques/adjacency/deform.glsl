#include "perTriangle/deform"
