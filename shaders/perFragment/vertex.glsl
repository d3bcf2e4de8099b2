#include "perFragment/rotationBetween"

