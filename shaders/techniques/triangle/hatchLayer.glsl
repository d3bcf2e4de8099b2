#include "perTriangle/hatchLayer"
