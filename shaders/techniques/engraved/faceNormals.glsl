#include "perFragment/faceNormals"
