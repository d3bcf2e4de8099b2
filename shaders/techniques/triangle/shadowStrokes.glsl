#include "perTriangle/shadowStrokes"
