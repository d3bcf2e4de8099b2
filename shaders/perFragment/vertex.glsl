#include "perFragment/rotationBetween"

attribute vec3 hatchNormal; // smoothed to the scale of a stroke; zero where the geometry has none
