#include "perTriangle/faded"
